// The draft's water: its rectangle, flat.
#include "shared/blocks.glsl"

out vec3 positionW;

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
    vec2 xz = waterRect.xy + corner * waterRect.zw;
    positionW = vec3(xz.x, waterLevel, xz.y);
    gl_Position = clipFromWorld * vec4(positionW, 1.0);
}

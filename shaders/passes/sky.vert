// One triangle over the whole target at the far plane; the direction of each pixel's ray.
#include "shared/blocks.glsl"

out vec3 directionW;

void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 1.0, 1.0);
    vec4 far = worldFromClip * vec4(corner, 1.0, 1.0);
    directionW = far.xyz / far.w - eye;
}

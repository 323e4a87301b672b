// The water's grid, displaced by the waves.
#include "shared/blocks.glsl"
#include "shared/waves.glsl"

layout(location = 0) in vec2 gridPosition; // -1 to 1 over the water's rectangle

out vec3 surfaceW;
#ifdef VERTEX_NORMALS
out vec2 vertexSlope;
#endif

void main()
{
    vec2 xz = waterRect.xy + gridPosition * waterRect.zw;
    vec3 sum = vec3(0.0); // height and slope
    for (int i = 0; i < int(waveCount); ++i) sum += waveTerm(waves[i], xz, time);
    surfaceW = vec3(xz.x, waterLevel + sum.x, xz.y);
#ifdef VERTEX_NORMALS
    vertexSlope = sum.yz;
#endif
    gl_Position = clipFromWorld * vec4(surfaceW, 1.0);
}

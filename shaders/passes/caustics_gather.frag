// Adds a photon, or a triangle between three, to the caustics texture.
#include "shared/sunlight.glsl"

#ifdef MESH
in vec2 cell;
in vec3 light;
#else
flat in vec2 centre;
flat in vec3 light;
#endif

out vec4 fragment;

void main()
{
#ifdef MESH
    // Photons that this texel's area holds: the ratio of the triangle's area on the surface to that on the bed, which
    // is one number all over a triangle. Where light folds back, its orientation changes and its amount does not.
    vec2 across = dFdx(cell);
    vec2 along = dFdy(cell);
    // Interpolation in slivers runs a little past their corners' values.
    fragment = vec4(max(light, vec3(0.0)) * abs(across.x * along.y - across.y * along.x), 1.0);
#else
    fragment = vec4(light * photonWeight(gl_FragCoord.xy - centre), 1.0);
#endif
}

// Adds a photon, or a triangle between three, to the caustics map.
#include "shared/refraction.glsl"
#include "shared/caustics.glsl"

flat in vec3 light;
flat in vec2 centre;
#ifdef MESH
flat in float isPoint;
#endif

out vec4 fragment;

void main()
{
    float weight = photonWeight(gl_FragCoord.xy - centre);
#ifdef MESH
    if (isPoint < 0.5) weight = 1.0;
#endif
    fragment = vec4(weight * light, 1.0);
}

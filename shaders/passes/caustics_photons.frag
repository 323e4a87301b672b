// The sun's photons, one a texel: the hit on the bed, and the flux (Mihálik 2008, sections 8.1 and 9.2).
//
// A texel is a ray of the sun that crosses the plane of the water level at a point of a regular lattice, so that all rays carry
// the same flux. R, G: the hit in the caustics map's coordinates, 0 to 1 inside it. B: the flux under the surface (photonFlux),
// less shadows. A: metres of water to the hit; attenuation differs between red, green and blue and is applied where the photon
// is gathered.
#include "shared/blocks.glsl"
#include "shared/refraction.glsl"
#include "shared/trigonometry.glsl"
#if WAVE_COUNT > 0
uniform float waveWeights[WAVE_COUNT]; // of each wave's amplitude: the lattice cannot sample waves shorter than its cells
#endif
#define WAVE_WEIGHTS
#include "shared/waves.glsl"
#include "shared/intersection.glsl"
#include "shared/sunlight.glsl"
#include "shared/caustics.glsl"
#define SHADOW_TAPS 2
#include "passes/sun_maps.glsl"

in vec2 uv;

out vec4 fragment;

// A of section 7.1 for a point W: where the refracted sunlight through W meets the bed, from the sun's depth map. Points are
// written (x, z, y), so that the third coordinate is the one that intersection.glsl compares.
vec3 bedBelow(vec3 W, vec2 shear)
{
    vec2 plane = sunPlane(W.xzy, waterLevel, shear);
    float height = heightFromDepth(textureLod(sunDepth, vec3(sunMapUv(sunRect, plane), submergedLayer), 0.0).r);
    return sunRayAtHeight(W, height, shear);
}

void main()
{
    vec2 plane = sunMapPlane(causticsRect, uv);
    fragment = vec4(uv, 0.0, 0.0); // no light, and a position that does not stretch the mesh
    if (any(greaterThan(abs(plane - waterRect.xy), waterRect.zw))) return;

    // U: the point at which the ray meets the waves.
    vec2 shearAbove = sunShear(sunDirection);
    WaveSum surface = weightedWaveSum(plane, time);
    float height = photonEntryHeight(surface.height, surface.slope, shearAbove);
    vec2 xz = plane + shearAbove * height;
#ifdef SURFACE_MOVES_SIDEWAYS // the waves' height shifts U by a considerable part of a photon's cell
    surface = weightedWaveSum(xz, time);
#endif
    vec3 U = vec3(xz, waterLevel + height);

    vec3 n = waveNormal(surface.slope);
    float cosine = dot(n, sunDirection);
    if (cosine <= 0.0) return; // the far side of a steep wave
    vec3 refracted = refractRay(-sunDirection, n, 1.0 / ior).xzy;

    vec2 shear = sunShear(sunDirectionBelow);
    vec3 hit = U;
    float path = 0.0;
    vec3 first = bedBelow(U, shear);
    if (first.z < U.z) { // else the surface is below the ground: texels at the shore
        IntersectionState s = intersectionBegin(U, refracted, first);
#define STEP(i) s = intersectionStepSampled(s, bedBelow(s.W, shear));
        EACH_STEP
#undef STEP
#ifdef PLANAR // a single sample of the bed's depth
        hit = s.W;
#else
        hit = s.best;
#endif
        path = distance(hit, U);
    }

    float flux = photonFlux(cosine, ior, causticsBorder.z, causticsBorder.y);
    // The bias keeps a beach that rises a hand above the water from shadowing the light that enters beside it.
#ifdef SHADOWS
    flux *= sunVisibility(firstCascadeLayer, sunRect, plane, U.z, vec2(0.0), 0.1);
#endif
    fragment = vec4(sunMapUv(causticsRect, sunPlane(hit.xzy, waterLevel, shear)), flux, path);
}

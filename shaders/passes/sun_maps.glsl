// Lookups in the sun's depth maps. Needs blocks.glsl and sunlight.glsl; SHADOW_TAPS: comparisons along an edge.

uniform sampler2D afloatDepth;    // along the sun, of what stands over the level: the first cascade
uniform sampler2D submergedDepth; // along the refracted sun, of what lies under it

vec2 sunMapUv(vec4 rect, vec2 plane) { return (plane - rect.xy) / rect.zw * 0.5 + 0.5; }

float heightFromDepth(float depth01) { return mix(sunHeights.y, sunHeights.x, depth01); }

bool isInside(vec4 rect, vec2 plane) { return all(lessThanEqual(abs(plane - rect.xy), rect.zw)); }

// The share of the sun's light that passes a map on its way to a point at height y: percentage-closer filtering
// (Reeves et al. 1987), a box of SHADOW_TAPS - 1 texels with linear edges. Each comparison is made with the height
// that the receiving plane has there, so that its own slope casts no shadow on it; the map's depth falls evenly with height,
// so that it is the plane that is turned into depths, once.
// rect: what the map covers; plane: sunPlane of the point; gradient: sunPlaneGradient of its surface.
float sunVisibility(sampler2D map, vec4 rect, vec2 plane, float y, vec2 gradient, float bias)
{
    ivec2 size = textureSize(map, 0);
    vec2 position = sunMapUv(rect, plane) * vec2(size);
    vec2 first = position - 0.5 * float(SHADOW_TAPS - 1);
    ivec2 corner = clamp(ivec2(floor(first)), ivec2(0), size - SHADOW_TAPS);
    float perMetre = 1.0 / (sunHeights.y - sunHeights.x); // of height, in depth; towards the sun is less
    vec2 perTexel = gradient * (2.0 * rect.zw / vec2(size)) * perMetre;
    float here = (sunHeights.y - y - bias) * perMetre - dot(perTexel, vec2(corner) + 0.5 - position);
    float sum = 0.0;
#if SHADOW_TAPS > 1
    vec2 part = clamp(first - vec2(corner), 0.0, 1.0);
#endif
    for (int j = 0; j < SHADOW_TAPS; ++j) {
        for (int i = 0; i < SHADOW_TAPS; ++i) {
            float lit = step(here - dot(perTexel, vec2(i, j)), texelFetch(map, corner + ivec2(i, j), 0).r);
#if SHADOW_TAPS > 1
            vec2 edge = vec2(i == 0 ? 1.0 - part.x : (i == SHADOW_TAPS - 1 ? part.x : 1.0),
                             j == 0 ? 1.0 - part.y : (j == SHADOW_TAPS - 1 ? part.y : 1.0));
            sum += edge.x * edge.y * lit;
#else
            sum += lit;
#endif
        }
    }
    sum /= float(SHADOW_TAPS > 1 ? (SHADOW_TAPS - 1) * (SHADOW_TAPS - 1) : 1);
    return isInside(rect, plane) ? sum : 1.0; // nothing is known beside the map
}

// Of a point in the air: the finest map that holds it knows (cascades, Engel 2006). SHADOW_CASCADES: bit i when what is
// drawn may lie in cascade i and in none before it.
#ifndef SHADOW_CASCADES
#define SHADOW_CASCADES 1
#endif
#if (SHADOW_CASCADES & 2) != 0
uniform sampler2D distantDepth0;
#endif
#if (SHADOW_CASCADES & 4) != 0
uniform sampler2D distantDepth1;
#endif

float sunVisibilityInAir(vec2 plane, float y, vec2 gradient)
{
#if (SHADOW_CASCADES & 1) != 0
#if SHADOW_CASCADES > 1
    if (isInside(sunRect, plane))
#endif
        return sunVisibility(afloatDepth, sunRect, plane, y, gradient, sunBiases.x);
#endif
#if (SHADOW_CASCADES & 2) != 0
#if SHADOW_CASCADES > 3
    if (isInside(sunRectsBeyond[0], plane))
#endif
        return sunVisibility(distantDepth0, sunRectsBeyond[0], plane, y, gradient, sunBiases.y);
#endif
#if (SHADOW_CASCADES & 4) != 0
    return sunVisibility(distantDepth1, sunRectsBeyond[1], plane, y, gradient, sunBiases.z);
#endif
    return 1.0;
}

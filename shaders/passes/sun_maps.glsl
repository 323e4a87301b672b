// Lookups in the sun's depth maps. Needs blocks.glsl and sunlight.glsl. SHADOW_TAPS: comparisons per side of the filter.

// Layer 0: along the refracted sun, of what is under the water level, over the first cascade's rectangle. Layers from 1: along
// the sun, of what is over the water level, one for each cascade.
uniform sampler2DArray sunDepth;
const int submergedLayer = 0, firstCascadeLayer = 1;

float heightFromDepth(float depth01) { return mix(sunHeights.y, sunHeights.x, depth01); }

bool isInside(vec4 rect, vec2 plane) { return all(lessThanEqual(abs(plane - rect.xy), rect.zw)); }

// The fraction of the sun's light that reaches a point at height y: percentage-closer filtering (Reeves et al. 1987) with a
// box of SHADOW_TAPS - 1 texels with linear edges. Each comparison is made with the height of the receiving plane there, so
// that its own slope casts no shadow on it; the map's depth is linear in height, so that the plane is converted to depths
// once.
// layer: of the map; rect: what it covers; plane: sunPlane of the point; gradient: sunPlaneGradient of its surface.
float sunVisibility(int layer, vec4 rect, vec2 plane, float y, vec2 gradient, float bias)
{
    ivec2 size = textureSize(sunDepth, 0).xy;
    vec2 position = sunMapUv(rect, plane) * vec2(size);
    vec2 first = position - 0.5 * float(SHADOW_TAPS - 1);
    ivec2 corner = clamp(ivec2(floor(first)), ivec2(0), size - SHADOW_TAPS);
    float perMetre = 1.0 / (sunHeights.y - sunHeights.x); // of height, in depth; towards the sun is less
    vec2 perTexel = gradient * (2.0 * rect.zw / vec2(size)) * perMetre;
    float here = (sunHeights.y - y - bias) * perMetre - dot(perTexel, vec2(corner) + 0.5 - position);
    float sum = 0.0;
#if SHADOW_TAPS > 1
    vec2 fraction = clamp(first - vec2(corner), 0.0, 1.0);
#endif
    for (int j = 0; j < SHADOW_TAPS; ++j) {
        for (int i = 0; i < SHADOW_TAPS; ++i) {
            float lit = step(here - dot(perTexel, vec2(i, j)), texelFetch(sunDepth, ivec3(corner + ivec2(i, j), layer), 0).r);
#if SHADOW_TAPS > 1
            vec2 weight = vec2(i == 0 ? 1.0 - fraction.x : (i == SHADOW_TAPS - 1 ? fraction.x : 1.0),
                               j == 0 ? 1.0 - fraction.y : (j == SHADOW_TAPS - 1 ? fraction.y : 1.0));
            sum += weight.x * weight.y * lit;
#else
            sum += lit;
#endif
        }
    }
    sum /= float(SHADOW_TAPS > 1 ? (SHADOW_TAPS - 1) * (SHADOW_TAPS - 1) : 1);
    return isInside(rect, plane) ? sum : 1.0; // outside the map nothing is known
}

// The same for a point in the air, from the finest cascade that contains it (Engel 2006). Each contains those before it, so
// that one lookup is enough.
float sunVisibilityInAir(vec2 plane, float y, vec2 gradient)
{
    int layer = firstCascadeLayer;
    vec4 rect = sunRect;
    float bias = sunBiases.x;
    if (sunRectsBeyond[0].z > 0.0 && !isInside(sunRect, plane)) {
        layer = firstCascadeLayer + 1;
        rect = sunRectsBeyond[0];
        bias = sunBiases.y;
    }
    if (sunRectsBeyond[1].z > 0.0 && !isInside(sunRectsBeyond[0], plane)) {
        layer = firstCascadeLayer + 2;
        rect = sunRectsBeyond[1];
        bias = sunBiases.z;
    }
    return sunVisibility(layer, rect, plane, y, gradient, bias);
}

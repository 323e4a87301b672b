// The alpha test of cut-out surfaces (leaves, reeds). Needs the maps of the material and the uniforms alpha and alphaCutoff.

float alphaOfMaps(vec2 at)
{
    float a = 1.0;
#ifdef DIFFUSE_MAP
    a *= texture(diffuseMap, at).a;
#endif
#ifdef ALPHA_MAP
    a *= texture(alphaMap, at).r;
#endif
    return a;
}

#ifdef DITHERED
uniform int chunk; // number of the draw in the scene: each counts its triangles from 0

// The fraction of a pixel that the surface covers. Mip levels from 1 hold coverage; at level 0 alpha crosses the cutoff within
// a texel, and a ramp one pixel wide about the cutoff is the pixel's coverage.
float cutOutFraction(vec2 at)
{
    float a = alphaOfMaps(at);
    float cutoff = alphaCutoff / max(alpha, 1.0e-6);
#ifdef ALPHA_MAP
    vec2 texels = vec2(textureSize(alphaMap, 0));
#else
    vec2 texels = vec2(textureSize(diffuseMap, 0));
#endif
    vec2 across = dFdx(at) * texels, along = dFdy(at) * texels;
    float mipLevel = 0.5 * log2(max(max(dot(across, across), dot(along, along)), 1.0e-12));
    float isCoverage = clamp(mipLevel, 0.0, 1.0);
    float width = mix(max(fwidth(a), 1.0e-4), 1.0, isCoverage);
    return clamp((a - mix(cutoff, 0.5, isCoverage)) / width + 0.5, 0.0, 1.0);
}

// A number from 0 to 1 for each triangle: the PCG hash (Jarzynski and Olano 2020, "Hash functions for GPU rendering").
float triangleNumber()
{
    uint state = (uint(gl_PrimitiveID) + 65537u * uint(chunk)) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

// Whether the pixel is discarded: it is kept with the probability of its coverage. Sixteen neighbours have sixteen evenly spaced
// limits (Bayer 1973), so that their mean is the coverage. The limits are shifted from triangle to triangle, or one leaf would
// hide all that is left of the leaf behind it, as it does with alpha-to-coverage.
bool isCutAway(vec2 at)
{
    uvec2 p = uvec2(gl_FragCoord.xy) & 3u;
    uint x = p.x ^ p.y;
    uint order = ((x & 1u) << 3u) | ((p.y & 1u) << 2u) | (x & 2u) | (p.y >> 1u);
    float limit = fract((float(order) + 0.5) / 16.0 + triangleNumber());
    return cutOutFraction(at) <= limit;
}
#else
bool isCutAway(vec2 at) { return alpha * alphaOfMaps(at) < alphaCutoff; }
#endif

// Radiance that an eye under water sees through the surface (Mihálik 2008, section 7.5), for water.frag.

#if defined(REFRACTION) && !defined(PAPER)
// The depth sample at a point's pixel. The target's eye is at the water level, so that half of the surface lies behind it;
// points outside the target get its border.
vec3 airDepthSample(vec3 w)
{
    w.z = min(w.z, -1.0e-3);
    return depthSample(w, refractionZ(w));
}
#endif

// Radiance in the air along a ray that leaves the water, the point W that it is taken from, and the fraction of it that comes
// from the target; the rest is sky.
vec3 lookupAir(vec3 refracted, out vec3 hit, out float fraction)
{
    hit = surfaceW + refractionDistance * refracted; // eq. 13
    fraction = 0.0;
    vec3 sky = texture(skyMap, refracted).rgb;
#ifdef REFRACTION
    vec3 u = (refractionViewFromWorld * vec4(surfaceW, 1.0)).xyz;
#ifdef PAPER
    vec3 w = (refractionViewFromWorld * vec4(hit, 1.0)).xyz;
    float known = step(w.z, 0.0);
#else
    // Section 7.1 again, now for what stands over the water.
    vec3 r = normalize(mat3(refractionViewFromWorld) * refracted);
    // Distant geometry lies in nearly the same direction from the target's eye as from U: the first sample is taken along the
    // ray itself, unless something near is found at the point of eq. 13.
    const float isNear = 3.0;
    vec3 first = airDepthSample(u + refractionDistance * r);
    if (distance(first, u) > isNear * refractionDistance) first = airDepthSample(r);
    IntersectionState s = intersectionBegin(u, r, first);
#define REFRACTION_STEP(i) s = intersectionStepSampled(s, airDepthSample(s.W));
    EACH_REFRACTION_STEP
#undef REFRACTION_STEP
    s = intersectionEnd(s);
    vec3 w = s.best;
    hit = (worldFromRefractionView * vec4(w, 1.0)).xyz;
    // A sample on the far plane is no point, and one that is far from the ray is no hit: both leave the sky.
    float known = texture(refractionDepth, refractionTexel(w)).r < 1.0 ? 1.0 : 0.0;
    known *= 1.0 - smoothstep(0.25, 0.75, s.bestDistance / max(distance(s.bestA, u), 1.0e-6));
#endif
    // The target holds what is in its frustum; outside only the sky is known.
    vec2 texel = refractionTexel(w);
    vec2 inside = smoothstep(vec2(0.0), vec2(0.04), texel) * smoothstep(vec2(0.0), vec2(0.04), 1.0 - texel);
    fraction = known * inside.x * inside.y;
    sky = mix(sky, texture(refractionColour, texel).rgb, fraction);
#endif
    return sky;
}

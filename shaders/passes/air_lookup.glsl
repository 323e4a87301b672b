// What an eye under water sees through the surface (Mihálik 2008, section 7.5), for water.frag.

#if defined(REFRACTION) && !defined(PAPER)
// What the target's eye, which is at the level, sees at a point's pixel. Half of the surface lies behind that eye; what
// it does not see is its target's border.
vec3 seenInAir(vec3 w)
{
    w.z = min(w.z, -1.0e-3);
    return seenThrough(w, refractionZ(w));
}
#endif

// Radiance in the air along a ray that leaves the water, the point W that it is taken from, and the target's share in
// it; the rest is sky.
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
    // What is far is seen in nearly the same direction from the target's eye as from U: the first look goes along the
    // ray itself, unless something near stands where the point of eq. 13 is looked for.
    const float isNear = 3.0;
    vec3 first = seenInAir(u + refractionDistance * r);
    if (distance(first, u) > isNear * refractionDistance) first = seenInAir(r);
    IntersectionState s = intersectionBegin(u, r, first);
#define REFRACTION_STEP(i) s = intersectionStepSeen(s, seenInAir(s.W));
    EACH_REFRACTION_STEP
#undef REFRACTION_STEP
    s = intersectionEnd(s);
    vec3 w = s.best;
    hit = (worldFromRefractionView * vec4(w, 1.0)).xyz;
    // The far plane holds no point, and one that is far off the ray is not what the ray meets: only the sky is left.
    float known = texture(refractionDepth, refractionTexel(w)).r < 1.0 ? 1.0 : 0.0;
    known *= 1.0 - smoothstep(0.25, 0.75, s.bestDistance / max(distance(s.bestA, u), 1.0e-6));
#endif
    // The target holds what the eye's own frustum holds; past its border only the sky is known.
    vec2 texel = refractionTexel(w);
    vec2 inside = smoothstep(vec2(0.0), vec2(0.04), texel) * smoothstep(vec2(0.0), vec2(0.04), 1.0 - texel);
    fraction = known * inside.x * inside.y;
    sky = mix(sky, texture(refractionColour, texel).rgb, fraction);
#endif
    return sky;
}

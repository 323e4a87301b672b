// The background: the baked sky, and the sun's disc if the pass asks for it.
#include "shared/blocks.glsl"

in vec3 directionW;

uniform samplerCube skyMap;
#ifdef WATERLINE
uniform sampler2D waterline; // 1 for pixels under water, waterline.frag
#endif

out vec4 fragment;

// The sun's disc: its irradiance over its solid angle, with an edge one pixel soft. A disc smaller than a pixel keeps
// its flux, more or less, by being drawn one pixel wide and dimmer. Half floats end at 65504.
vec3 sunDisc(vec3 direction)
{
    const float angularRadius = 0.004652;
    float radius = max(angularRadius, 0.5 * pixelAngle);
    float angle = length(cross(direction, sunDirection)); // the sine; exact enough for so small an angle
    if (dot(direction, sunDirection) < 0.0 || sunDirection.y < -angularRadius) return vec3(0.0);
    float coverage = 1.0 - smoothstep(radius - 0.5 * pixelAngle, radius + 0.5 * pixelAngle, angle);
    return min(sunIrradiance * (coverage / (3.14159265 * radius * radius)), vec3(60000.0));
}

void main()
{
#ifdef UNDERWATER
    fragment = vec4(deepRadiance, 1.0); // nothing but water along the ray
#else
    vec3 direction = normalize(directionW);
    vec3 radiance = texture(skyMap, direction).rgb;
#ifdef SUN_DISC
    radiance += sunDisc(direction);
#endif
#ifdef WATERLINE
    radiance = mix(radiance, deepRadiance, texelFetch(waterline, ivec2(gl_FragCoord.xy), 0).r);
#endif
    fragment = vec4(radiance, 1.0);
#endif
}

// The sun's highlight on the water, in a small target (Mihálik 2008, section 9.3).
#include "shared/blocks.glsl"
#include "shared/refraction.glsl"
#include "shared/trigonometry.glsl"
#include "shared/waves.glsl"
#include "shared/normal_map.glsl"
#include "shared/depth.glsl"
#include "passes/water_surface.glsl"

uniform sampler2D sceneDepth;
uniform vec3 glowColour;
uniform float glowExponent;

out vec4 fragment;

void main()
{
    // The small target has no depth of its own. A fragment here covers several texels of the picture's depth, so only what is
    // clearly nearer than the water hides it.
    float sceneDistance = -viewZFromDepth(texture(sceneDepth, gl_FragCoord.xy / pixels).r, nearPlane, farPlane);
    float waterDistance = -viewZFromDepth(gl_FragCoord.z, nearPlane, farPlane);
    if (sceneDistance < 0.95 * waterDistance - 0.1) discard;

    Surface surface = surfaceHere();
    vec3 toEye = normalize(eye - surfaceW);
    vec3 mirrored = reflectRay(-sunDirection, surface.meanNormal);
    float highlight = pow(max(dot(mirrored, toEye), 1.0e-6), glowExponent); // 0 to a power is undefined in GLSL
    fragment = vec4(highlight * glowColour, 1.0);
}

// Shows a target of another size as it is (debug views).
#include "shared/depth.glsl"

in vec2 uv;

uniform sampler2D source;
uniform vec2 nearFar; // of the camera that made a depth texture

out vec4 fragment;

void main()
{
    vec4 texel = texture(source, uv);
#ifdef DEPTH
    fragment = texel.r < 1.0 ? vec4(vec3(-viewZFromDepth(texel.r, nearFar.x, nearFar.y)), 1.0) : vec4(0.0);
#else
    fragment = vec4(texel.rgb, 1.0);
#endif
}

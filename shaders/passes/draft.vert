// Static geometry for the draft: what every variant of it needs, and no more.
#include "shared/blocks.glsl"

layout(location = 0) in vec3 positionM;
layout(location = 1) in vec3 normalM;
layout(location = 3) in vec2 uvM;
layout(location = 4) in vec4 colourM;

uniform mat4 worldFromModel;
uniform mat3 worldFromModelNormal;

out vec3 positionW;
out vec3 normalW;
out vec2 uv;
out vec3 tint;

void main()
{
    vec4 position = worldFromModel * vec4(positionM, 1.0);
    positionW = position.xyz;
    normalW = worldFromModelNormal * normalM;
    uv = uvM;
    tint = colourM.rgb;
    gl_Position = clipFromWorld * position;
}

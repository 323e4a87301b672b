// Static geometry, for every view of it (scene, refraction and reflection passes).
#include "shared/blocks.glsl"
#ifdef FLAT_WATER
#include "shared/refraction.glsl"
#endif

layout(location = 0) in vec3 positionM;
layout(location = 1) in vec3 normalM;
layout(location = 2) in vec4 tangentM;
layout(location = 3) in vec2 uvM;
layout(location = 4) in vec4 colourM;

// The depth prepass and the shading pass must compute the same depth exactly.
invariant gl_Position;

uniform mat4 worldFromModel;
uniform mat3 worldFromModelNormal;

out vec3 positionW;
out vec3 normalW;
out vec2 uv;
out vec3 tint;
#ifdef NORMAL_MAP
out vec4 tangentW;
#endif

void main()
{
    vec4 position = worldFromModel * vec4(positionM, 1.0);
    positionW = position.xyz;
    normalW = worldFromModelNormal * normalM;
#ifdef NORMAL_MAP
    tangentW = vec4(mat3(worldFromModel) * tangentM.xyz, tangentM.w);
#endif
    uv = uvM;
    tint = colourM.rgb;
#ifdef FLAT_WATER
    gl_Position = clipFromWorld * vec4(flatApparent(eye, position.xyz, waterLevel, ior), 1.0);
#else
    gl_Position = clipFromWorld * position;
#endif
    gl_ClipDistance[0] = dot(clipPlane, position); // only views that clip enable it
}

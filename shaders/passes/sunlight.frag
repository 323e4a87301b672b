// The shape of the scene alone. Depth along the sun: nothing is written but what the depth test keeps. Cut-outs are tested
// as in scene.frag. COUNT_FACES: how often a line of sight enters solids less how often it leaves them, when added up.
#ifdef ALPHA_TEST
in vec2 uv;
#ifdef DIFFUSE_MAP
uniform sampler2D diffuseMap;
#endif
#ifdef ALPHA_MAP
uniform sampler2D alphaMap;
#endif
uniform float alpha;
uniform float alphaCutoff;
#include "passes/cut_out.glsl"
#endif

#ifdef COUNT_FACES
out vec4 faces;
#endif

void main()
{
#ifdef ALPHA_TEST
    if (isCutAway(uv)) discard;
#endif
#ifdef COUNT_FACES
    faces = vec4(gl_FrontFacing ? 1.0 : -1.0);
#endif
}

// Depth along the sun: nothing is written but what the depth test keeps. Cut-outs are tested as in scene.frag.
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

void main()
{
#ifdef ALPHA_TEST
    if (isCutAway(uv)) discard;
#endif
}

// The side of the surface on which each pixel's rays begin, for a near plane that the surface cuts.
//
// Red: 1 if the pixel begins under water; for everything but the surface. A pixel on the line takes the side of those samples
// whose rays do not meet the surface: of rays that go down those that begin below it, of rays that go up those above.
// Green: 1 for pixels on the line. There the surface is chosen sample by sample: a ray that begins above it meets its upper
// side first, one that begins below its lower side. Elsewhere it takes the side in red: along a crest's silhouette rounding
// would let samples of the facet behind through.
#include "shared/blocks.glsl"
#include "shared/trigonometry.glsl"
#include "shared/waves.glsl"
#include "shared/water_grid.glsl"

in vec2 uv;

uniform vec3 nearCorner; // of the near plane, world
uniform vec3 nearAcross; // its edges
uniform vec3 nearUp;

out vec4 fragment;

float heightOver(vec3 p)
{
    return p.y - waterLevel - gridHeight(p.xz, time, waterGrid[0], waterGrid[1]);
}

void main()
{
    vec3 p = nearCorner + uv.x * nearAcross + uv.y * nearUp;
    float height = heightOver(p);
    float halfPixel = 0.5 * fwidth(height);
    bool sinks = heightOver(p + 0.01 * (p - eye)) < height;
    bool isUnder = height < (sinks ? halfPixel : -halfPixel);
    bool isInside = all(lessThanEqual(abs(p.xz - waterRect.xy), waterRect.zw));
    fragment = vec4(isUnder && isInside ? 1.0 : 0.0, abs(height) < 3.0 * halfPixel ? 1.0 : 0.0, 0.0, 1.0);
}

// Which side of the surface each pixel is on, where the near plane cuts it: 1 where the picture begins under water.
//
// Red is for what a pixel shows past the surface. There a pixel on the line takes the side of those of its samples that
// the surface leaves open: where rays go down, the ones that begin below it, and where they go up, the ones above.
// Green marks the pixels on the line. The water in them goes sample by sample: a ray that begins above meets the
// surface's upper side first, and one that begins below its lower side. Elsewhere its side is red's: along a crest's
// silhouette rounding lets a sample of the facet behind through.
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

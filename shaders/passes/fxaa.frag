// Smooths the edges of the shown picture (frame.antialiasing = fxaa); shared/fxaa.glsl.
//
// The luma of a texel is its alpha. The search has a fixed number of steps and never breaks out of its loop, which would
// save nothing on hardware that runs neighbouring pixels in lockstep.
#include "shared/fxaa.glsl"

in vec2 uv;

uniform sampler2D source; // linearly filtered: a sample between two texels is their mean

out vec4 fragment;

float lumaAt(vec2 at) { return textureLod(source, at, 0.0).a; }

// Of a neighbour itself, without the four texels that a filter would read; beyond the border, the border's.
float lumaBeside(int x, int y)
{
    ivec2 at = clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), textureSize(source, 0) - 1);
    return texelFetch(source, at, 0).a;
}

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(source, 0));
    vec4 colour = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
    vec3 above = vec3(lumaBeside(-1, 1), lumaBeside(0, 1), lumaBeside(1, 1));
    vec3 middle = vec3(lumaBeside(-1, 0), colour.a, lumaBeside(1, 0));
    vec3 below = vec3(lumaBeside(-1, -1), lumaBeside(0, -1), lumaBeside(1, -1));
    float darkest = min(min(min(above.y, below.y), min(middle.x, middle.z)), colour.a);
    float brightest = max(max(max(above.y, below.y), max(middle.x, middle.z)), colour.a);
    float sides = above.y + below.y + middle.x + middle.z;
    float corners = above.x + above.z + below.x + below.z;

    // The side that differs more lies over the edge.
    bool across = fxaaRunsAcross(above, middle, below);
    float lumaUp = across ? above.y : middle.z, lumaDown = across ? below.y : middle.x;
    bool isUp = abs(lumaUp - colour.a) > abs(lumaDown - colour.a);
    float lumaOver = isUp ? lumaUp : lumaDown;
    vec2 over = (across ? vec2(0.0, texel.y) : vec2(texel.x, 0.0)) * (isUp ? 1.0 : -1.0);
    vec2 along = across ? vec2(texel.x, 0.0) : vec2(0.0, texel.y);

    // From between the two sides both ways along the edge, to where the mean of both is no longer that of here.
    float mean = 0.5 * (colour.a + lumaOver);
    float end = 0.25 * abs(lumaOver - colour.a);
    vec2 start = uv + 0.5 * over;
    float back = 0.0, on = 0.0, backDifference = 0.0, onDifference = 0.0;
    bool isBackDone = false, isOnDone = false;
    for (int i = 0; i < fxaaSteps; ++i) {
        back += isBackDone ? 0.0 : fxaaStride(i);
        on += isOnDone ? 0.0 : fxaaStride(i);
        backDifference = isBackDone ? backDifference : lumaAt(start - back * along) - mean;
        onDifference = isOnDone ? onDifference : lumaAt(start + on * along) - mean;
        isBackDone = isBackDone || abs(backDifference) >= end;
        isOnDone = isOnDone || abs(onDifference) >= end;
    }
    // The run ends in a step that cuts into this pixel's side when the mean there leaves for the other side of this luma.
    float nearerDifference = back < on ? backDifference : onDifference;
    bool isCut = (nearerDifference < 0.0) != (colour.a < mean);
    float shift = max(fxaaEdgeShift(back, on, isCut),
                      fxaaSubpixelShift(colour.a, sides, corners, brightest - darkest));
    if (!fxaaIsEdge(darkest, brightest)) shift = 0.0;
    fragment = vec4(textureLod(source, uv + shift * over, 0.0).rgb, 1.0);
}

// Uniform blocks, as GLSL and as C++ see them. Only vec4, mat4, ivec4 and vec3 + float pairs are used, for which
// std140 and C++ agree; src/render checks every offset against the driver once.
//
// UNIFORM_BLOCK(Name) is `layout(std140) uniform Name` in GLSL and `struct Name` in C++.

const int maxWaves = 64;
const int maxLights = 8;

// One sine component, ready to evaluate: y = amplitude · sin(k·x − omega·t + phase).
struct WaveTerm {
    vec2 k;           // rad/m, in the xz plane
    float omega;      // rad/s
    float phase;      // rad
    float amplitude;  // m
    float wavenumber; // |k|
    float pad0;
    float pad1;
};

// A point or spot light. cosOuter = -2 marks a point light.
struct LightTerm {
    vec3 position;  // world, m
    float cosInner;
    vec3 intensity; // per steradian
    float cosOuter;
    vec3 direction; // unit, the direction in which the light travels
    float pad0;
};

// One axis of the grid that draws the water: the positions of its lines of vertices (water_grid.glsl).
struct GridAxis {
    float lower;    // ends of the water's rectangle, m
    float upper;
    float centre;   // where lines are closest, m
    float scale;    // m around the centre in which they are even; 0: even all along
    float from;     // asinh((position - centre) / scale) of the second line, the first that is in view
    float to;       // of the last but one
    float vertices; // how many lines
    float pad0;
};

// The same for every pass of a frame.
UNIFORM_BLOCK(FrameBlock) {
    vec3 sunDirection;   // towards the sun
    float time;          // s
    vec3 sunIrradiance;  // on a surface facing the sun, above the water
    float waterLevel;    // m
    vec3 sunDirectionBelow; // towards the refracted sun, seen from under flat water
    float ior;
    vec3 sunBelow;          // irradiance just under flat water, on a surface facing the refracted sun
    float hasWater;          // 1 or 0
    vec3 absorption;     // 1/m
    float waveCount;
    vec3 deepRadiance;   // radiance inside infinitely deep water
    float lightCount;
    vec3 skyBelow;       // irradiance of the sky on an upward surface just under flat water
    float sunSlopeDeviation;  // base slope deviation of the sun's glint
    vec4 waterRect;      // centre x, z and half extent x, z
    GridAxis waterGrid[2];   // of the drawn surface, along x and z
    vec4 skyIrradiance[9];   // spherical harmonics, lighting.glsl
    LightTerm lights[maxLights];
};

// One view of the scene: the main camera or a moved one.
UNIFORM_BLOCK(ViewBlock) {
    mat4 clipFromWorld;
    mat4 viewFromWorld;
    mat4 worldFromClip;
    vec3 eye;            // world
    float nearPlane;
    vec4 clipPlane;      // world: what has dot(plane, vec4(p, 1)) >= 0 is drawn; all zero clips nothing
    vec2 pixels;         // size of the target
    float farPlane;
    float pixelAngle;    // radians a pixel spans at the centre
};

// The maps that the sun's light is looked up in (shared/sunlight.glsl): rectangles on the plane of the water level.
UNIFORM_BLOCK(SunBlock) {
    vec4 sunRect;        // first cascade of the shadow maps: centre x, z and half extent x, z, m
    vec4 sunRectsBeyond[2]; // the further cascades, of the air only: each holds those before it; 0: there is none
    vec4 sunHeights;     // world y at their depth 1 and at depth 0, m; unused
    vec4 sunBiases;      // of a comparison in each cascade, m; unused
    vec4 causticsRect;   // caustics texture: centre x, z and half extent x, z, m
    vec4 causticsBorder; // width of its fading border; size of a texel; size of a photon's cell, m; unused
};

// The water's waves.
UNIFORM_BLOCK(WavesBlock) {
    WaveTerm waves[maxWaves];
};

// The lie of the land: how high the ground is at every place, and what kind of shore it is.
//
// The lake is drawn by hand: a table of shore radii and kinds of shore by compass direction, smoothed by a
// spline and roughened by noise. x is east, z is south, y is up; the water rests at y = 0.
#pragma once

#include "noise.h"

namespace tarn::lake {

/// Shares of the three kinds of shore at a place; they add up to 1.
struct ShoreKind {
    float beach = 0.0f, bank = 0.0f, cliff = 0.0f;
};

struct Ground {
    float height = 0.0f;
    float shore = 0.0f; ///< metres from the nearest shore line, lake's or island's; positive on land
    ShoreKind kind;
};

inline constexpr vec2 islandCentre{-10.0f, -8.0f};
inline constexpr float terrainHalfSize = 300.0f;

class LakeShape {
public:
    explicit LakeShape(std::uint32_t seed) : noise_(seed) {}

    Ground at(vec2 p) const;
    float height(vec2 p) const { return at(p).height; }
    vec3 onGround(vec2 p) const { return {p.x, height(p), p.y}; }

    /// Up from the ground; `step` is the distance over which the slope is taken.
    vec3 normal(vec2 p, float step) const;

    /// The first place along a ray from inside the lake where the ground rises above the water.
    vec2 shoreAlong(vec2 origin, float angleDegrees) const;

private:
    float mainShore(vec2 p, ShoreKind& kind) const;
    float basin(vec2 p, float shore, const ShoreKind& kind) const;
    float land(vec2 p, float shore, const ShoreKind& kind) const;
    float island(vec2 p, float& shore) const;

    Noise noise_;
};

} // namespace tarn::lake

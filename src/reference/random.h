// Numbers that look random and depend on nothing but their place: pixel, sample, seed. Private to src/reference.
#pragma once

#include "base/math.h"

#include <cmath>
#include <cstdint>

namespace tarn::reference {

/// SplitMix64's finaliser (Steele, Lea & Flood 2014).
inline std::uint64_t mixBits(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

class Random {
public:
    Random(std::uint64_t seed, std::uint64_t stream) : state_(mixBits(seed ^ mixBits(stream))) {}
    /// 0 <= x < 1
    double next()
    {
        state_ = mixBits(state_);
        return static_cast<double>(state_ >> 11) * 0x1.0p-53;
    }
    glm::dvec2 next2()
    {
        const double x = next();
        return {x, next()};
    }

private:
    std::uint64_t state_;
};

/// The additive sequence of the plastic number, which fills the unit square evenly (Roberts 2018), moved by an offset.
inline glm::dvec2 evenlySpread(std::uint64_t index, const glm::dvec2& offset)
{
    constexpr double plastic = 1.32471795724474602596;
    const double n = static_cast<double>(index);
    const double x = offset.x + n / plastic, y = offset.y + n / (plastic * plastic);
    return {x - std::floor(x), y - std::floor(y)};
}

/// A point of the unit disc from one of the unit square (Shirley & Chiu 1997).
inline glm::dvec2 discFromSquare(const glm::dvec2& square)
{
    const glm::dvec2 p = 2.0 * square - 1.0;
    if (p.x == 0.0 && p.y == 0.0) return p;
    constexpr double quarter = std::numbers::pi / 4.0;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double radius = wide ? p.x : p.y;
    const double angle = wide ? quarter * (p.y / p.x) : 2.0 * quarter - quarter * (p.x / p.y);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Two unit vectors across a third (Duff et al. 2017).
struct Across {
    glm::dvec3 a, b;
    explicit Across(const glm::dvec3& n)
    {
        const double sign = std::copysign(1.0, n.z);
        const double c = -1.0 / (sign + n.z), d = n.x * n.y * c;
        a = {1.0 + sign * n.x * n.x * c, sign * d, -sign * n.x};
        b = {d, sign + n.y * n.y * c, -n.y};
    }
};

} // namespace tarn::reference

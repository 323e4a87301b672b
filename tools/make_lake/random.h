// Random numbers that are the same on every run: the standard library's distributions are not fixed by the
// standard.
#pragma once

#include "base/math.h"

#include <cstdint>

namespace tarn::lake {

/// An int as a float, without the warning.
constexpr float real(int value) { return static_cast<float>(value); }

/// PCG-XSH-RR 32 (O'Neill 2014).
class Random {
public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 1) : increment_(2 * stream + 1)
    {
        next();
        state_ += seed;
        next();
    }

    std::uint32_t next()
    {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005ull + increment_;
        const auto xorShifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return (xorShifted >> turn) | (xorShifted << ((32 - turn) & 31));
    }

    /// 0 to 1, 1 excluded.
    float unit() { return static_cast<float>(next() >> 8) * 0x1p-24f; }
    float range(float lower, float upper) { return lower + (upper - lower) * unit(); }
    /// -1 to 1.
    float sign() { return range(-1.0f, 1.0f); }
    /// 0 to count - 1.
    int index(int count) { return static_cast<int>(unit() * real(count)); }
    /// About normal, deviation 1, never beyond ±3.
    float normal() { return (unit() + unit() + unit() + unit() - 2.0f) * 1.7320508f; }
    float angle() { return range(0.0f, 2.0f * pi); }

    vec3 direction()
    {
        const float y = sign(), turn = angle(), r = std::sqrt(std::max(0.0f, 1.0f - y * y));
        return {r * std::cos(turn), y, r * std::sin(turn)};
    }

private:
    std::uint64_t state_ = 0;
    std::uint64_t increment_;
};

} // namespace tarn::lake

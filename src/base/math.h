// The vector types that every folder uses, and the few helpers GLM lacks.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <limits>
#include <numbers>

namespace tarn {

using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::mat3;
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr float pi = std::numbers::pi_v<float>;

/// Axis-aligned box. Empty until something is added.
struct Bounds {
    vec3 lower{std::numeric_limits<float>::max()};
    vec3 upper{std::numeric_limits<float>::lowest()};

    bool empty() const { return lower.x > upper.x; }
    vec3 centre() const { return 0.5f * (lower + upper); }
    vec3 extent() const { return empty() ? vec3(0.0f) : upper - lower; }

    void add(const vec3& point)
    {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }
    void add(const Bounds& other)
    {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    /// The box around this box's image under an affine map.
    Bounds transformed(const mat4& bFromA) const
    {
        Bounds result;
        if (empty()) return result;
        for (int corner = 0; corner < 8; ++corner) {
            const vec3 point((corner & 1) ? upper.x : lower.x, (corner & 2) ? upper.y : lower.y,
                             (corner & 4) ? upper.z : lower.z);
            result.add(vec3(bFromA * vec4(point, 1.0f)));
        }
        return result;
    }
};

} // namespace tarn

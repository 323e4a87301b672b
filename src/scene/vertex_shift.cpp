#include "scene/vertex_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tarn {

namespace {

vec3 colourOf(const Vertex& vertex)
{
    const auto channel = [&](unsigned shift) { return static_cast<float>((vertex.colour >> shift) & 255u) / 255.0f; };
    return {channel(0), channel(8), channel(16)};
}

} // namespace

float seemingShift(const Vertex& truth, const std::array<const Vertex*, 3>& corners, const vec3& weights,
                   float metresPerUv)
{
    vec3 normal(0.0f), colour(0.0f);
    vec2 uv(0.0f);
    float reach2 = std::numeric_limits<float>::max(), longest2 = 0.0f;
    for (int k = 0; k < 3; ++k) {
        const Vertex& corner = *corners[static_cast<std::size_t>(k)];
        normal += weights[k] * corner.normal;
        colour += weights[k] * colourOf(corner);
        uv += weights[k] * corner.uv;
        const vec3 away = corner.position - truth.position;
        const vec3 edge = corners[static_cast<std::size_t>((k + 1) % 3)]->position - corner.position;
        reach2 = std::min(reach2, glm::dot(away, away)); // there all is right again
        longest2 = std::max(longest2, glm::dot(edge, edge));
    }
    const vec3 across =
        glm::cross(corners[1]->position - corners[0]->position, corners[2]->position - corners[0]->position);
    const float width2 = glm::dot(across, across) / std::max(longest2, 1.0e-12f);
    const float patch = std::sqrt(std::min(reach2, width2));

    // What differs by a fiftieth is not seen; by a tenth, wherever it covers a pixel.
    constexpr float unseen = 0.02f, seen = 0.1f, darkest = 0.05f;
    constexpr float rounding = 1.0f / 255.0f; // of colours in eight bits
    const vec3 wanted = colourOf(truth), off = glm::abs(colour - wanted);
    const float tint =
        std::max(std::max({off.x, off.y, off.z}) - rounding, 0.0f) / std::max({wanted.x, wanted.y, wanted.z, darkest});
    const float shade = glm::distance(normal / std::max(glm::length(normal), 1.0e-6f), truth.normal);
    const float contrast = glm::clamp((std::max(tint, shade) - unseen) / (seen - unseen), 0.0f, 1.0f);
    return std::max(contrast * patch, metresPerUv * glm::distance(uv, truth.uv));
}

} // namespace tarn

#include "views.h"

#include "pier.h"

namespace tarn::lake {

std::vector<View> views(const LakeShape& shape)
{
    const PierSite pier = pierSite(shape);
    const vec2 beach = shape.shoreAlong({0.0f, 15.0f}, 100.0f);
    const auto above = [&](vec2 p, float height) { return vec3(p.x, std::max(shape.height(p), 0.0f) + height, p.y); };
    const auto at = [](vec2 p, float y) { return vec3(p.x, y, p.y); };
    const vec2 boat = pier.at(pier.length - 7.2f, -2.45f);
    const vec2 cliff(-33.0f, -37.0f);
    return {
        {"overview", above({-50.0f, 51.0f}, 7.6f), {1.0f, -1.5f, -6.0f}, 46.0f, 40.0f},
        {"shallows", at(beach + vec2(1.0f, 0.8f), 1.75f), at(beach + vec2(-4.6f, -6.0f), -0.7f), 55.0f, 12.0f},
        {"far-shore", at(beach + vec2(-8.0f, -4.5f), 0.75f), {-33.0f, 3.6f, -40.0f}, 40.0f, 25.0f},
        {"mirror", at(islandCentre + vec2(18.0f, 25.5f), 0.55f), at(islandCentre + vec2(-0.5f, -1.0f), 1.3f), 46.0f,
         25.0f},
        {"pier", at(pier.at(4.6f, 3.5f), 0.95f), at(pier.at(11.5f, 0.2f), -0.05f), 52.0f, 12.0f},
        {"deep", at({17.0f, 11.0f}, 5.2f), {3.0f, -4.0f, 1.0f}, 52.0f, 12.0f},
        {"glitter", above(cliff, 2.8f), at(cliff + vec2(13.4f, 14.8f), -0.5f), 60.0f, 26.0f},
        {"snell", at(pier.at(16.0f, 4.6f), -1.15f), at(pier.at(14.2f, 0.0f), 0.55f), 84.0f, 12.0f},
        {"bed", at({-9.0f, 20.0f}, -1.35f), {-17.5f, -2.6f, 17.0f}, 62.0f, 12.0f},
        {"boat", at(boat + 4.6f * vec2(-0.55f, -0.83f) + 1.2f * pier.direction, 1.55f), at(boat, 0.1f), 44.0f, 12.0f},
        {"reeds", at({-45.0f, 8.0f}, 0.8f), {-60.0f, 0.7f, 12.0f}, 46.0f, 9.0f},
        {"cliff", at({-24.0f, -20.0f}, 1.3f), {-35.0f, 3.0f, -37.0f}, 52.0f, 14.0f},
    };
}

bool blocksView(const std::vector<View>& all, vec2 p, float radius, Growth growth)
{
    for (const View& view : all) {
        const vec2 eye(view.eye.x, view.eye.z), forward = glm::normalize(vec2(view.target.x, view.target.z) - eye);
        const vec2 d = p - eye;
        const float distance = glm::length(d);
        if (distance < radius + 1.2f) return true;
        if (distance > (growth == Growth::tall ? view.clearing : view.lowClearing) + radius) continue;
        // 16:9 at most, plus the thing's own radius.
        const float half =
            std::atan(1.78f * std::tan(0.5f * glm::radians(view.fov))) + std::asin(std::min(0.95f, radius / distance));
        if (glm::dot(d, forward) > std::cos(std::min(half, 3.1f)) * distance) return true;
    }
    return false;
}

} // namespace tarn::lake

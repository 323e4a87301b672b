#include "render/update_interval.h"

#include "optics/optics.h"
#include "optics/refraction_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tarn {

namespace {

/// Waves that moved for so long are others, s.
constexpr double longestPause = 0.5;

/// Whether the eye went so far that what it sees of the water is another part of it.
bool movedAway(const UpdateState& before, const UpdateState& now)
{
    const float height = std::abs(before.camera.eye.y - before.water.level);
    constexpr float perHeight = 0.25f, least = 0.1f; // m
    return glm::distance(before.camera.eye, now.camera.eye) > std::max(perHeight * height, least);
}

/// Whether a corner of the picture lies beside a target that was drawn for the earlier camera, whose field of
/// view is `extension` times as wide.
bool turnedAway(const UpdateState& before, const UpdateState& now, float extension)
{
    const float aspect = static_cast<float>(now.size.x) / static_cast<float>(now.size.y);
    const mat3 beforeFromNow = mat3(viewFromWorld(before.camera)) * glm::transpose(mat3(viewFromWorld(now.camera)));
    const ViewTangents picture(clipFromView(now.camera, aspect));
    const ViewTangents target(clipFromView(before.camera, aspect, extension));
    for (const vec2 corner : {vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1)}) {
        const vec3 direction = beforeFromNow * vec3(corner * picture.half + picture.middle, -1.0f);
        if (direction.z >= 0.0f) return true;
        const vec2 at = (vec2(direction) / -direction.z - target.middle) / target.half;
        if (std::max(std::abs(at.x), std::abs(at.y)) > 1.0f) return true;
    }
    return false;
}

/// Of the narrower of both targets.
float leastExtension(const UpdateState& state)
{
    const float height = std::abs(state.camera.eye.y - state.water.level);
    const RefractionOptions& refraction = state.options.refraction;
    const ReflectionOptions& reflection = state.options.reflection;
    return std::min(optics::fovExtension(height, refraction.fovExtensionNear, refraction.fovExtensionFar),
                    optics::fovExtension(height, reflection.fovExtensionNear, reflection.fovExtensionFar));
}

} // namespace

bool isJump(const UpdateState& before, const UpdateState& now)
{
    return before.options != now.options || before.water != now.water || before.size != now.size ||
           before.rebuilt != now.rebuilt || before.side != now.side ||
           std::abs(now.time - before.time) > longestPause || movedAway(before, now) ||
           turnedAway(before, now, leastExtension(before));
}

bool UpdateInterval::serves(const UpdateState& now, std::uint64_t frame, int interval) const
{
    const auto frames = static_cast<std::uint64_t>(interval);
    const bool isDue = (frame + phase_) % frames == 0 || frame - drawnFrame_ >= frames;
    return drawn_ && !isDue && !isJump(*drawn_, now);
}

bool UpdateInterval::isStale(const UpdateState& now) const
{
    return !drawn_ || drawn_->camera != now.camera || drawn_->time != now.time ||
           drawn_->causticsDrawn != now.causticsDrawn;
}

void UpdateInterval::wasDrawn(UpdateState now, std::uint64_t frame)
{
    drawn_ = std::move(now);
    drawnFrame_ = frame;
}

} // namespace tarn

#include "render/view.h"

#include "optics/optics.h"
#include "optics/refraction_camera.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

View viewOf(const Camera& camera, float aspect, float extension)
{
    View view;
    view.viewFromWorld = viewFromWorld(camera);
    view.clipFromView = clipFromView(camera, aspect, extension);
    view.eye = camera.eye;
    view.nearPlane = camera.nearPlane;
    view.farPlane = camera.farPlane;
    return view;
}

vec4 keepBelow(float height) { return {0.0f, -1.0f, 0.0f, height}; }
vec4 keepAbove(float height) { return {0.0f, 1.0f, 0.0f, -height}; }

/// The factor on a submerged camera's field of view (tangents) that holds what its rays meet in the air, once a flat
/// surface has bent them. More than `most` spreads the target's texels too thin: an eye that looks straight up sees the
/// whole horizon.
float extensionThroughSurface(const View& view, float ior, float least, float most)
{
    const ViewTangents tangents(view.clipFromView);
    const mat3 worldFromView = glm::transpose(mat3(view.viewFromWorld));
    constexpr int across = 16;
    constexpr float forWaves = 1.1f; // their slopes turn rays a little further
    float extension = least;
    for (int j = 0; j <= across; ++j) {
        for (int i = 0; i <= across; ++i) {
            const vec2 at(2.0f * static_cast<float>(i) / across - 1.0f, 2.0f * static_cast<float>(j) / across - 1.0f);
            const vec3 direction = normalize(worldFromView * vec3(at * tangents.half + tangents.middle, -1.0f));
            if (direction.y <= 0.0f) continue;
            const vec3 bent = optics::refractRay(direction, vec3(0.0f, -1.0f, 0.0f), ior);
            if (bent == vec3(0.0f)) continue; // mirrored
            const vec3 ray = mat3(view.viewFromWorld) * bent;
            const float far = std::max(-ray.z, 1.0e-3f);
            const vec2 needed = glm::abs(vec2(ray) - far * tangents.middle) / (far * tangents.half);
            extension = std::max(extension, forWaves * std::max(needed.x, needed.y));
        }
    }
    return std::min(extension, std::max(least, most));
}

} // namespace

Frustum View::frustum() const
{
    const vec2 scale = 2.0f / (lookedUp.upper - lookedUp.lower);
    const vec2 middle = 0.5f * (lookedUp.lower + lookedUp.upper);
    const mat4 cropped = glm::scale(mat4(1.0f), vec3(scale, 1.0f)) * glm::translate(mat4(1.0f), vec3(-middle, 0.0f));
    return Frustum(lookedUp.isWhole() ? clipFromWorld() : cropped * clipFromWorld());
}

View mainView(const Camera& camera, float aspect) { return viewOf(camera, aspect, 1.0f); }

View refractionView(const Camera& camera, float aspect, const WaterBody& water, const Options& allOptions,
                    bool underwater)
{
    const RefractionOptions& options = allOptions.refraction;
    const float height = std::abs(camera.eye.y - water.level);
    const float extension = optics::fovExtension(height, options.fovExtensionNear, options.fovExtensionFar);
    if (underwater) {
        const bool asPublished = allOptions.underwater.refraction == UnderwaterOptions::Refraction::paper;
        constexpr float widest = 3.0f;
        const float wide =
            asPublished ? extension : extensionThroughSurface(mainView(camera, aspect), water.ior, extension, widest);
        View view = viewOf(camera, aspect, wide);
        view.clipPlane = keepAbove(water.level - options.clipOffset);
        if (asPublished) return view;
        view.viewFromWorld *= glm::translate(mat4(1.0f), vec3(0.0f, camera.eye.y - water.level, 0.0f));
        view.eye.y = water.level;
        return view;
    }
    View view = viewOf(camera, aspect, extension);
    view.clipPlane = keepBelow(water.level + options.clipOffset);
    // Waves may hold the eye's height over the level as small as this without a flat surface between.
    constexpr float leastHeight = 0.02f;
    if (options.camera == RefractionOptions::CameraMode::flat && camera.eye.y > water.level + leastHeight)
        view.flatWater = water.level;
    // A sheared frustum is turned with its camera, by the angle of the ray below the axis.
    if (options.camera == RefractionOptions::CameraMode::snell) {
        const optics::RefractionCamera turned = optics::refractionCamera(
            camera.eye, normalize(camera.target - camera.eye), camera.up, camera.verticalFov, water.level, water.ior);
        view.viewFromWorld = glm::lookAt(turned.eye, turned.eye + turned.forward, turned.up);
        view.eye = turned.eye;
    }
    return view;
}

View reflectionView(const Camera& camera, float aspect, const WaterBody& water, const ReflectionOptions& options,
                    bool underwater)
{
    const float height = std::abs(camera.eye.y - water.level);
    const float extension = optics::fovExtension(height, options.fovExtensionNear, options.fovExtensionFar);
    View view = viewOf(camera, aspect, extension);
    const mat4 mirror = glm::translate(mat4(1.0f), vec3(0.0f, 2.0f * water.level, 0.0f)) *
                        glm::scale(mat4(1.0f), vec3(1.0f, -1.0f, 1.0f));
    view.viewFromWorld = view.viewFromWorld * mirror;
    view.eye.y = 2.0f * water.level - view.eye.y;
    view.mirrored = true;
    view.clipPlane =
        underwater ? keepBelow(water.level + options.clipOffset) : keepAbove(water.level - options.clipOffset);
    return view;
}

float geometryErrorOf(const View& view, ivec2 size, float pixels)
{
    const mat4 rows = glm::transpose(view.isParallel() ? view.clipFromWorld() : view.clipFromView);
    const vec2 half = 0.5f * vec2(size);
    if (view.isParallel()) // at most the two axes' pixels per metre together
        return pixels / glm::length(vec2(half.x * glm::length(vec3(rows[0])), half.y * glm::length(vec3(rows[1]))));
    // What moves by d at a distance r from the eye, seen at tangents t from the axis, moves by f/z (d_xy - t d_z)
    // pixels, z = r / sqrt(1 + t²): at most f d/r (1 + t²), most in the farthest corner.
    const ViewTangents tangents(view.clipFromView);
    const vec2 corner = glm::abs(tangents.middle) + tangents.half;
    const vec2 focal = half / tangents.half;
    return pixels / (std::max(focal.x, focal.y) * (1.0f + glm::dot(corner, corner)));
}

blocks::ViewBlock viewBlock(const View& view, ivec2 size)
{
    blocks::ViewBlock block{};
    block.clipFromWorld = view.clipFromWorld();
    block.viewFromWorld = view.viewFromWorld;
    block.worldFromClip = glm::inverse(block.clipFromWorld);
    block.eye = view.eye;
    block.nearPlane = view.nearPlane;
    block.clipPlane = view.clipPlane;
    block.pixels = vec2(size);
    block.farPlane = view.farPlane;
    // clipFromView[1][1] is 1 / tan(fov / 2); at the centre a pixel spans 2 tan / height.
    block.pixelAngle = 2.0f / (view.clipFromView[1][1] * static_cast<float>(size.y));
    return block;
}

} // namespace tarn

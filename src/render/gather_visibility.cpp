#include "render/gather_visibility.h"

#include "plan/frame_plan.h"
#include "render/view.h"
#include "render/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tarn {

std::vector<SceneBox> listBoxes(const Scene& scene)
{
    std::vector<SceneBox> boxes;
    for (const Instance& instance : flatten(scene))
        for (const MeshPart& part : scene.meshes[static_cast<std::size_t>(instance.mesh)].parts)
            boxes.push_back({part.bounds.transformed(instance.worldFromModel), part.material});
    return boxes;
}

namespace {

/// The part of a box that the water covers at rest, with the rim that it wets (scene.frag); empty where there is none.
Bounds submergedPart(const Bounds& box, const WaterBody& water)
{
    constexpr float rim = 0.01f;
    const vec2 lower = water.centre - 0.5f * water.extent - rim, upper = water.centre + 0.5f * water.extent + rim;
    Bounds part = box;
    part.lower = glm::max(part.lower, vec3(lower.x, part.lower.y, lower.y));
    part.upper = glm::min(part.upper, vec3(upper.x, water.level, upper.y));
    const bool isDry = box.lower.y >= water.level || part.lower.x > part.upper.x || part.lower.z > part.upper.z;
    return isDry ? Bounds{} : part;
}

/// The largest value of scene.frag's BRDF, 1/sr.
vec3 largestReflectance(const Material& material)
{
    const float n = std::max(material.shininess, 0.0f);
    const float highlight = (n + 2.0f) * (n + 4.0f) / (8.0f * pi * (n + std::exp2(-0.5f * n)));
    return material.diffuse / pi * (1.0f + material.transmission) + material.specular * highlight;
}

} // namespace

VisibilityFacts gatherVisibility(const std::vector<SceneBox>& boxes, const Scene& scene, const WaterBody& water,
                                 const Camera& camera, ivec2 size, const Options& options,
                                 const blocks::FrameBlock& light)
{
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const View main = mainView(camera, aspect);
    const View refraction = refractionView(camera, aspect, water, options, false);
    View mirrored = reflectionView(camera, aspect, water, options.reflection, false);
    if (options.plan.allows(RuleId::targetBounds))
        mirrored.lookedUp = mirrorBounds(water, camera, options, scaledSize(size, options.frame));
    const WaterCover cover = waterCover(water), none;
    VisibilityFacts visibility;
    visibility.mirrors = visibility.seesBed = visibility.mainReceives = visibility.refractionReceives =
        visibility.reflectionReceives = false;
    visibility.leastDepth = std::numeric_limits<float>::max();
    for (const SceneBox& box : boxes) {
        const bool inRefraction = mayShow(refraction, none, box.boundsW),
                   inMirror = mayShow(mirrored, none, box.boundsW);
        visibility.mirrors |= inMirror;
        if (inRefraction) {
            const Material& material = scene.materials[static_cast<std::size_t>(box.material)];
            visibility.seesBed = true;
            visibility.leastDepth = std::min(visibility.leastDepth, water.level - box.boundsW.upper.y);
            visibility.bedReflectance = glm::max(visibility.bedReflectance, largestReflectance(material));
            visibility.bedEmission = glm::max(visibility.bedEmission, material.emissive);
        }
        const Bounds wet = submergedPart(box.boundsW, water);
        if (wet.empty()) continue;
        visibility.mainReceives |= mayShow(main, cover, wet);
        visibility.refractionReceives |= inRefraction;
        visibility.reflectionReceives |= inMirror && mayShow(mirrored, none, wet);
    }
    visibility.sunBelow = light.sunBelow;
    visibility.skyBelow = light.skyBelow;
    visibility.deepRadiance = light.deepRadiance;
    return visibility;
}

} // namespace tarn

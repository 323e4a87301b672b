#include "scene/scene.h"

#include <algorithm>

namespace tarn {

void visit(FieldVisitor& v, WaterBody& water)
{
    v.enter("water", "The body of water");
    v.field({"level", "Height of the surface at rest", "m", -1e5, 1e5}, water.level);
    v.field({"centre", "Middle of the water's rectangle, x and z", "m", -1e6, 1e6}, water.centre);
    v.field({"extent", "Edge lengths of the water's rectangle, x and z", "m", 1e-3, 1e6}, water.extent);
    v.field({"ior", "Index of refraction relative to air", "", 1.0, 4.0}, water.ior);
    v.field({"absorption", "Absorption coefficient k for red, green and blue", "1/m", 0.0, 1000.0}, water.absorption);
    v.field({"colour", "Diffuse reflectance of infinitely deep water", "", 0.0, 1.0}, water.colour);
    v.field({"normal_map", "Ripples of the scene's normal map on the surface, where it has one"},
            water.normalMap.enabled);
    v.field({"normal_map_tile", "Edge of the water that the normal map covers once", "m", 0.001, 10000.0},
            water.normalMap.tile);
    v.field({"normal_map_bump", "Factor on the upward part of the ripples' normals: 1 plain, 0 steepest (Lipp)", "",
             0.0, 1.0},
            water.normalMap.bump);
    v.leave();
}

std::array<glm::dvec2, 4> layerOffsets(const WaterNormalMap& map, double time)
{
    const glm::dvec2 apart(0.37, 0.61); // of two layers at time 0: no whole number of tiles for any of them
    std::array<glm::dvec2, 4> offsets;
    for (std::size_t i = 0; i < offsets.size(); ++i)
        offsets[i] = glm::fract(static_cast<double>(i) * apart -
                                glm::dvec2(map.layers[i].velocity) * (time / static_cast<double>(map.tile)));
    return offsets;
}

const Camera* Scene::findCamera(std::string_view cameraName) const
{
    const auto found =
        std::find_if(cameras.begin(), cameras.end(), [&](const Camera& camera) { return camera.name == cameraName; });
    return found == cameras.end() ? nullptr : &*found;
}

namespace {

mat4 parentFromElement(const Element& element)
{
    // "About x, then y, then z" as a product acts from the right: Rz · Ry · Rx.
    const mat4 rotation = glm::mat4_cast(glm::angleAxis(element.rotation.z, vec3(0.0f, 0.0f, 1.0f)) *
                                         glm::angleAxis(element.rotation.y, vec3(0.0f, 1.0f, 0.0f)) *
                                         glm::angleAxis(element.rotation.x, vec3(1.0f, 0.0f, 0.0f)));
    return glm::scale(glm::translate(mat4(1.0f), element.translation) * rotation, element.scale);
}

/// Into Scene::meshes, or -1.
int meshOfShape(const Scene& scene, std::string_view shape)
{
    for (const Model& model : scene.models)
        if (model.name == shape) return model.mesh;
    for (const Primitive& primitive : scene.primitives)
        if (primitive.name == shape) return primitive.mesh;
    return -1;
}

void flattenInto(std::vector<Instance>& instances, const Scene& scene, const Element& element,
                 const mat4& worldFromParent)
{
    if (!element.visible) return;
    const mat4 worldFromElement = worldFromParent * parentFromElement(element);
    if (!element.shape.empty()) {
        if (const int mesh = meshOfShape(scene, element.shape); mesh >= 0)
            instances.push_back({mesh, worldFromElement, element.name.empty() ? element.shape : element.name});
    }
    for (const Element& child : element.children) flattenInto(instances, scene, child, worldFromElement);
}

} // namespace

std::vector<Instance> flatten(const Scene& scene)
{
    std::vector<Instance> instances;
    for (const Element& element : scene.elements) flattenInto(instances, scene, element, mat4(1.0f));
    return instances;
}

void releaseTexels(Scene& scene)
{
    for (Image& image : scene.images) {
        image.bytes = {};
        image.floats = {};
    }
}

Bounds worldBounds(const Scene& scene)
{
    Bounds bounds;
    for (const Instance& instance : flatten(scene)) {
        const Bounds& box = scene.meshes[static_cast<std::size_t>(instance.mesh)].bounds;
        if (!box.empty()) bounds.add(box.transformed(instance.worldFromModel));
    }
    return bounds;
}

} // namespace tarn

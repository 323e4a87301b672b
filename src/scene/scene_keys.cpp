#include "scene/scene_keys.h"

#include <array>

namespace tarn {

namespace {

// Beyond these a float has lost its millimetres, and a typing error is likelier than a wish.
constexpr KeyRange metres{-1e6, 1e6, "m"};
constexpr KeyRange light{0.0, 1e9};
constexpr KeyRange zeroToOne{0.0, 1.0};
constexpr KeyRange anyDegrees{-36000.0, 36000.0, "degrees"};

constexpr KeyRange positive(double upper, const char* unit = "") { return {0.0, upper, unit, true}; }

constexpr std::array skyKinds{"constant", "daylight", "picture"};
constexpr std::array primitiveKinds{"plane", "box", "sphere"};

} // namespace

void keys(TableIo& io, Sky& sky)
{
    io.choice("kind", sky.kind, skyKinds);
    io.uniform("radiance", sky.radiance, light);
    io.number("turbidity", sky.turbidity, {2.0, 10.0});
    io.number("ground_albedo", sky.groundAlbedo, zeroToOne);
    io.path("file", sky.file);
    io.angle("rotation", sky.rotation, anyDegrees);
    io.number("lighting", sky.lighting, {0.0, 1000.0});
}

void keys(TableIo& io, WaterBody& water)
{
    io.number("level", water.level, metres);
    io.vector("centre", water.centre, metres);
    io.uniform("extent", water.extent, positive(1e6, "m"));
    io.number("ior", water.ior, {1.0, 4.0});
    io.uniform("absorption", water.absorption, {0.0, 1000.0, "1/m"});
    io.uniform("colour", water.colour, zeroToOne);
    io.path("normal_map", water.normalMap.file);
    io.number("normal_map_tile", water.normalMap.tile, {0.001, 10000.0, "m"});
    io.number("normal_map_bump", water.normalMap.bump, zeroToOne);
}

void keys(TableIo& io, WaterNormalMap::Layer& layer)
{
    io.vector("velocity", layer.velocity, {-1000.0, 1000.0, "m/s"});
}

void keys(TableIo& io, GivenMap& map)
{
    io.path("file", map.file);
    io.vector("centre", map.centre, metres);
    io.uniform("extent", map.extent, positive(1e6, "m"));
}

void keys(TableIo& io, Wave& wave)
{
    io.number("amplitude", wave.amplitude, {0.0, 1000.0, "m"});
    io.number("wavelength", wave.wavelength, positive(1e5, "m"));
    io.angle("direction", wave.direction, anyDegrees);
    io.angle("phase", wave.phase, anyDegrees);
    io.number("period", wave.period, {0.0, 1e5, "s"});
}

void keys(TableIo& io, Material& material, MaterialFiles& files)
{
    io.text("name", material.name);
    io.uniform("diffuse", material.diffuse, zeroToOne);
    io.uniform("specular", material.specular, zeroToOne);
    io.uniform("transmission", material.transmission, zeroToOne);
    io.number("shininess", material.shininess, {1.0, 10000.0});
    io.uniform("emissive", material.emissive, light);
    io.number("alpha", material.alpha, zeroToOne);
    io.path("diffuse_map", files.diffuse);
    io.path("emissive_map", files.emissive);
    io.path("alpha_map", files.alpha);
    io.path("normal_map", files.normal);
    io.path("bump_map", files.bump);
    io.number("bump_scale", files.bumpScale, {-1000.0, 1000.0});
    io.flag("two_sided", material.twoSided);
    io.number("alpha_cutoff", material.alphaCutoff, zeroToOne);
}

void keys(TableIo& io, Model& model)
{
    io.text("name", model.name);
    io.path("file", model.file);
    io.text("material", model.material);
}

void keys(TableIo& io, Primitive& primitive, std::string& materialName)
{
    io.text("name", primitive.name);
    io.choice("kind", primitive.kind, primitiveKinds);
    io.vector("size", primitive.size, positive(1e6, "m"));
    io.integer("segments", primitive.segments, {1.0, 1024.0});
    io.uniform("uv_scale", primitive.uvScale, {-1e5, 1e5});
    io.text("material", materialName);
}

void keys(TableIo& io, Element& element)
{
    io.text("name", element.name);
    io.text("shape", element.shape);
    io.vector("translation", element.translation, metres);
    io.angles("rotation", element.rotation);
    io.uniform("scale", element.scale, {-1e6, 1e6});
    io.flag("visible", element.visible);
}

void keys(TableIo& io, PointLight& point)
{
    io.text("name", point.name);
    io.vector("position", point.position, metres);
    io.uniform("intensity", point.intensity, light);
}

void keys(TableIo& io, SpotLight& spot)
{
    io.text("name", spot.name);
    io.vector("position", spot.position, metres);
    io.vector("direction", spot.direction);
    io.uniform("intensity", spot.intensity, light);
    io.angle("inner_angle", spot.innerAngle, positive(89.9, "degrees"));
    io.angle("outer_angle", spot.outerAngle, positive(89.9, "degrees"));
}

void keys(TableIo& io, Camera& camera)
{
    io.text("name", camera.name);
    io.vector("eye", camera.eye, metres);
    io.vector("target", camera.target, metres);
    io.vector("up", camera.up);
    io.angle("fov", camera.verticalFov, {1.0, 170.0, "degrees"});
    io.number("near", camera.nearPlane, positive(1e6, "m"));
    io.number("far", camera.farPlane, positive(1e7, "m"));
}

} // namespace tarn

// What a scene is: plain data, no GL. Scene::load (scene_file.h) reads it from TOML or OBJ.
//
// Units: metres, seconds, radians (degrees in files); y is up. Light is linear RGB on one scale:
// radiance in kcd/m² per channel, irradiance in klx per channel, so that a clear noon has a sun of about 100.
// A scene lit by constants may use any scale it likes: nothing but the exposure knows.
#pragma once

#include "base/fields.h"
#include "base/math.h"
#include "scene/camera.h"
#include "scene/image.h"
#include "scene/map_picture.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tarn {

struct Vertex {
    vec3 position;
    vec3 normal;
    vec4 tangent;                       ///< xyz along +u, w = ±1: bitangent = w · cross(normal, tangent)
    vec2 uv;                            ///< v runs upward, as in OBJ
    std::uint32_t colour = 0xffffffffu; ///< RGBA8, linear, multiplies the diffuse reflectance (OBJ "v x y z r g b")
};

inline constexpr int noImage = -1;

/// Reflectances are linear. Maps multiply the constants. Image indices point into Scene::images.
struct Material {
    std::string name;
    vec3 diffuse{0.8f};        ///< Kd
    vec3 specular{0.0f};       ///< Ks
    vec3 transmission{0.0f};   ///< Tf, alpha-tested surfaces only: diffuse transmittance of the thin leaf, as a share
                               ///< of its diffuse reflectance
    float shininess = 32.0f;   ///< Ns, Blinn-Phong exponent
    vec3 emissive{0.0f};       ///< Ke, radiance
    float alpha = 1.0f;        ///< d; below alphaCutoff the surface is not there
    int diffuseMap = noImage;  ///< map_Kd, sRGB; its alpha channel counts as map_d when it has one
    int emissiveMap = noImage; ///< map_Ke, sRGB
    int alphaMap = noImage;    ///< map_d, linear
    int normalMap = noImage;   ///< norm (tangent space), or map_Bump turned into normals on loading
    bool alphaTested = false;  ///< has an alpha map, or a diffuse map with alpha
    bool twoSided = false;     ///< never back-face culled; normals turn towards the viewer. Set for alpha-tested ones
    float alphaCutoff = 0.5f;
    float bumpScale = 0.0f; ///< > 0: normalMap was made from a height picture with this multiplier
    bool fromModel = false; ///< came with a model's MTL, and is saved there, not in the scene file
};

/// A chunk: triangles of one material that lie close together, so that it can be culled as one.
struct MeshPart {
    int material = 0;
    std::uint32_t firstIndex = 0, indexCount = 0;
    Bounds bounds; ///< model space
};

struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< triangles, counter-clockwise from outside
    std::vector<MeshPart> parts;        ///< parts of one material stand together
    Bounds bounds;
};

/// A mesh read from an OBJ file.
struct Model {
    std::string name;
    std::filesystem::path file; ///< as written in the scene file, relative to it
    int mesh = -1;              ///< into Scene::meshes
    std::string material;       ///< name of a scene material that replaces all of the MTL's, or empty
};

struct Primitive {
    enum class Kind { plane, box, sphere };
    std::string name;
    Kind kind = Kind::plane;
    vec3 size{1.0f};  ///< plane: x, z extents (y unused); box: edge lengths; sphere: diameters
    int segments = 1; ///< plane: quads a side; sphere: rings (default 32)
    vec2 uvScale{1.0f};
    int material = 0; ///< into Scene::materials
    int mesh = -1;
};

/// A node of the tree of transforms.
struct Element {
    std::string name;
    vec3 translation{0.0f};
    vec3 rotation{0.0f}; ///< about x, then y, then z, radians (degrees in files)
    vec3 scale{1.0f};
    std::string shape; ///< name of a model or primitive, or empty: only a group
    bool visible = true;
    std::vector<Element> children;
};

/// Directional light.
struct Sun {
    vec3 direction{0.0f, 1.0f, 0.0f}; ///< unit, towards the sun
    vec3 irradiance{0.0f};            ///< on a surface facing the sun, above the water
    bool automatic = true;            ///< irradiance computed from the daylight model
};

struct Sky {
    enum class Kind { constant, daylight, picture };
    Kind kind = Kind::daylight;
    vec3 radiance{1.0f};        ///< constant: its radiance; picture: multiplies it
    float turbidity = 3.0f;     ///< daylight (Preetham et al. 1999): 2 (clear) to 10 (haze)
    float groundAlbedo = 0.15f; ///< daylight: below the horizon, a grey ground lit by sun and sky
    std::filesystem::path file; ///< picture: latitude-longitude (2:1) or cube map (4:3 cross, 6:1 or 1:6 strip)
    int image = noImage;
    float rotation = 0.0f; ///< picture: about y, radians
    float lighting = 1.0f; ///< scales the light it casts on surfaces, not what is seen of it
};

struct PointLight {
    std::string name;
    vec3 position{0.0f};
    vec3 intensity{1.0f}; ///< per steradian: irradiance at distance r is intensity / r²
};

struct SpotLight {
    std::string name;
    vec3 position{0.0f};
    vec3 direction{0.0f, -1.0f, 0.0f}; ///< unit, the way the light goes
    vec3 intensity{1.0f};
    float innerAngle = 0.35f, outerAngle = 0.5f; ///< half angles, radians; smooth between
};

/// One sine component: y = amplitude · sin(k·x − ωt + phase), k = 2π/wavelength along direction.
struct Wave {
    float amplitude = 0.05f; ///< m
    float wavelength = 4.0f; ///< m
    float direction = 0.0f;  ///< radians in the xz plane, from +x towards +z
    float phase = 0.0f;      ///< radians
    float period = 0.0f;     ///< s; 0: deep-water dispersion, ω² = g·k
    bool operator==(const Wave&) const = default;
};

/// Ripples on the surface, as a picture of its normals in four layers that drift: shaders/shared/normal_map.glsl.
struct WaterNormalMap {
    std::filesystem::path file; ///< as written in the scene file, relative to it
    int image = noImage;        ///< red, green, blue: x, y (up), z; +x to the right and +z upward in the picture
    bool enabled = true;
    float tile = 2.0f; ///< edge of the water that the picture covers once, m
    float bump = 1.0f; ///< factor on y before the normal is used: 1 plain, 0 steepest
    struct Layer {
        vec2 velocity{0.0f}; ///< of its drift along x and z, m/s
        bool operator==(const Layer&) const = default;
    };
    std::array<Layer, 4> layers{
        {{vec2(0.31f, 0.08f)}, {vec2(-0.12f, 0.27f)}, {vec2(0.05f, -0.23f)}, {vec2(-0.2f, -0.13f)}}};

    bool isSeen() const { return enabled && image != noImage; }
    bool operator==(const WaterNormalMap&) const = default;
};

/// What is added to (x, z) / tile for each layer's place in the picture at a time in seconds, 0..1. Layers do not lie
/// upon each other at time 0.
std::array<glm::dvec2, 4> layerOffsets(const WaterNormalMap& map, double time);

/// A body of water: a horizontal rectangle at `level`. Its defaults are Mihálik 2008, Table 1.
struct WaterBody {
    bool present = false;
    float level = 0.0f;            ///< y of the surface at rest, m
    vec2 centre{0.0f};             ///< of its rectangle, x and z
    vec2 extent{100.0f};           ///< edge lengths, x and z
    float ior = 1.33f;             ///< index of refraction, relative to air
    vec3 absorption{0.5f};         ///< k of eq. 4, 1/m for red, green and blue
    vec3 colour{0.0f, 0.2f, 0.1f}; ///< watercol: diffuse reflectance of infinitely deep water. Its radiance inside
                                   ///< the water is colour · (downwelling irradiance under the surface) / π
    std::vector<Wave> waves;       ///< at most 64
    WaterNormalMap normalMap;
    bool operator==(const WaterBody&) const = default;
};

/// The body's scalar and vector fields, in the group "water".
void visit(FieldVisitor& visitor, WaterBody& water);

/// A map of heights that is given as a picture; without one it is drawn.
struct GivenMap {
    std::filesystem::path file;      ///< as written in the scene file, relative to it; empty: none
    vec2 centre{0.0f}, extent{0.0f}; ///< as written there, m: what it covers; zero extent: what its header says
    std::optional<HeightMapPicture> picture;
};

struct SceneMaps {
    GivenMap bed, aboveWater;
};

struct Scene {
    std::string name;
    std::filesystem::path file; ///< what it was loaded from

    std::vector<Image> images;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Model> models;
    std::vector<Primitive> primitives;
    std::vector<Element> elements;

    std::optional<Sun> sun;
    Sky sky;
    std::vector<PointLight> pointLights;
    std::vector<SpotLight> spotLights;
    std::vector<Camera> cameras; ///< at least one after loading
    WaterBody water;
    SceneMaps maps;

    std::vector<Assignment> options; ///< the scene file's [options], for the program to apply

    /// Null when there is no camera of that name.
    const Camera* findCamera(std::string_view cameraName) const;
};

/// Frees the texels of all images; names, sizes and channels stay. For the owner of a scene that is drawn from the
/// graphics card's memory. What reads texels itself needs the scene whole: another upload, the reference.
void releaseTexels(Scene& scene);

/// A mesh placed in the world.
struct Instance {
    int mesh = -1;
    mat4 worldFromModel{1.0f};
    std::string name;
};

/// The visible leaves of the element tree.
std::vector<Instance> flatten(const Scene& scene);

/// World-space bounds of all visible instances.
Bounds worldBounds(const Scene& scene);

} // namespace tarn

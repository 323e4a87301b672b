#include "scene/scene_toml.h"

#include "base/error.h"
#include "base/fields.h"
#include "base/log.h"
#include "scene/scene_keys.h"
#include "scene/table_reader.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

constexpr int deepestElement = 64;

class SceneParser {
public:
    SceneParser(const toml::table& root, const std::filesystem::path& file, TextureQueue& textures)
        : root_(root, file.string(), ""), file_(file.string()), textures_(textures)
    {
        scene_.file = file;
    }

    Scene parse()
    {
        scene_.name = scene_.file.stem().string();
        root_.text("name", scene_.name);
        readOptions();
        readSun();
        readSky();
        readWater();
        readMaps();
        readMaterials();
        readModels();
        readPrimitives();
        readElements();
        readLights();
        readCameras();
        root_.finish();
        if (scene_.models.empty() && scene_.primitives.empty())
            throw Error("{}: nothing to draw; add [[models]] or [[primitives]]", file_);
        return std::move(scene_);
    }

private:
    TableReader reader(const toml::table& table, std::string section) const
    {
        return {table, file_, std::move(section)};
    }

    // ---- options

    void readOptions()
    {
        if (const auto* table = root_.subtable("options")) flattenOptions(*table, "");
    }

    void flattenOptions(const toml::table& table, const std::string& prefix)
    {
        for (const auto& [key, node] : table) {
            const std::string name = prefix + std::string(key.str());
            if (const auto* inner = node.as_table()) {
                flattenOptions(*inner, name + ".");
            } else {
                const std::string origin = fmt::format("{}:{}", file_, node.source().begin.line);
                scene_.options.push_back({name, optionText(node, name, origin), origin});
            }
        }
    }

    static std::string optionText(const toml::node& node, const std::string& name, const std::string& origin)
    {
        if (const auto* text = node.as_string()) return text->get();
        if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
        if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
        if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
        const auto* array = node.as_array();
        if (!array) throw Error("{}: options.{} must be a value, not {}", origin, name, typeName(node));
        std::string joined;
        for (const toml::node& entry : *array) {
            if (entry.is_array()) throw Error("{}: options.{} must hold numbers, not arrays", origin, name);
            joined += (joined.empty() ? "" : ",") + optionText(entry, name, origin);
        }
        return joined;
    }

    // ---- light

    static bool normalise(vec3& direction)
    {
        const float length = glm::length(direction);
        if (!(length > 1e-12f) || !std::isfinite(length)) return false;
        direction /= length;
        return true;
    }

    void readSun()
    {
        const auto* table = root_.subtable("sun");
        if (!table) return;
        TableReader io = reader(*table, "sun");
        Sun sun;
        float elevation = glm::radians(45.0f), azimuth = 0.0f;
        io.angle("elevation", elevation, {-90.0, 90.0, "degrees"});
        io.angle("azimuth", azimuth, {-36000.0, 36000.0, "degrees"});
        sun.direction = {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                         std::cos(elevation) * std::sin(azimuth)};
        if (table->contains("direction") && (table->contains("elevation") || table->contains("azimuth")))
            io.fail("direction", "excludes elevation and azimuth; give one or the other");
        io.vector("direction", sun.direction, {});
        if (!normalise(sun.direction)) io.fail("direction", "must not be zero");

        const toml::node* irradiance = io.find("irradiance");
        sun.automatic = !irradiance || irradiance->is_string();
        if (sun.automatic) {
            std::string text = "auto";
            io.text("irradiance", text);
            if (text != "auto") io.fail("irradiance", "must be \"auto\", a number or three, not '" + text + "'");
        } else {
            io.uniform("irradiance", sun.irradiance, {0.0, 1e9});
        }
        io.finish();
        scene_.sun = sun;
    }

    void readSky()
    {
        const auto* table = root_.subtable("sky");
        if (!table) return;
        TableReader io = reader(*table, "sky");
        keys(io, scene_.sky);
        io.finish();
        if (scene_.sky.kind != Sky::Kind::picture) return;
        if (scene_.sky.file.empty()) io.fail("file", "is missing; a sky of kind \"picture\" needs one");
        scene_.sky.image = request(scene_.sky.file, TextureUse::sky, io.place("file"));
    }

    void readLights()
    {
        for (const auto* table : root_.tables("point_lights")) {
            TableReader io = reader(*table, "point_lights");
            keys(io, scene_.pointLights.emplace_back());
            io.finish();
        }
        for (const auto* table : root_.tables("spot_lights")) {
            TableReader io = reader(*table, "spot_lights");
            SpotLight& light = scene_.spotLights.emplace_back();
            keys(io, light);
            io.finish();
            if (!normalise(light.direction)) io.fail("direction", "must not be zero");
            if (light.innerAngle > light.outerAngle) io.fail("inner_angle", "must not be larger than outer_angle");
        }
    }

    // ---- water

    void readWater()
    {
        const auto* table = root_.subtable("water");
        if (!table) return;
        TableReader io = reader(*table, "water");
        WaterBody& water = scene_.water;
        water.present = true;
        keys(io, water);
        for (const auto* waveTable : io.tables("waves")) {
            TableReader waveIo = reader(*waveTable, "water.waves");
            keys(waveIo, water.waves.emplace_back());
            waveIo.finish();
            if (water.waves.size() > maxWaveCount)
                throw Error("{}: more than {} waves; leave the smallest out", waveIo.place(), maxWaveCount);
        }
        readNormalMap(io, *table);
        io.finish();
    }

    void readNormalMap(TableReader& io, const toml::table& table)
    {
        WaterNormalMap& map = scene_.water.normalMap;
        const auto layers = io.tables("normal_layers");
        if (map.file.empty()) {
            for (const char* key : {"normal_map_tile", "normal_map_bump", "normal_layers"})
                if (table.contains(key)) io.fail(key, "needs a normal_map");
            return;
        }
        if (!layers.empty() && layers.size() != map.layers.size())
            io.fail("normal_layers", fmt::format("must be {}, not {}", map.layers.size(), layers.size()));
        for (std::size_t i = 0; i < layers.size(); ++i) {
            TableReader layerIo = reader(*layers[i], "water.normal_layers");
            layerIo.require({"velocity"});
            keys(layerIo, map.layers[i]);
            layerIo.finish();
        }
        map.image = request(map.file, TextureUse::waterNormal, io.place("normal_map"));
    }

    // ---- maps of heights

    void readMaps()
    {
        const auto* table = root_.subtable("maps");
        if (!table) return;
        TableReader io = reader(*table, "maps");
        readMap(io, MapKind::bed, scene_.maps.bed);
        readMap(io, MapKind::aboveWater, scene_.maps.aboveWater);
        io.finish();
    }

    /// A scene without its maps would be another: nothing stands in for one that cannot be read.
    void readMap(TableReader& maps, MapKind kind, GivenMap& map)
    {
        std::string name = mapName(kind);
        const auto* table = maps.subtable(name.c_str());
        if (!table && kind == MapKind::aboveWater) { // an older name of it
            table = maps.subtable("afloat");
            if (table) log::warning("{}: maps.afloat is called maps.{} now", maps.place("afloat"), name);
            if (table) name = "afloat";
        }
        if (!table) return;
        TableReader io = reader(*table, "maps." + name);
        keys(io, map);
        io.finish();
        io.require({"file"});
        const bool saysExtent = table->contains("extent");
        if (table->contains("centre") && !saysExtent) io.fail("extent", "is missing; a centre needs one");
        try {
            map.picture = readMapPicture(scene_.file.parent_path() / map.file, kind);
        } catch (const Error& problem) {
            throw Error("{}: {}", io.place("file"), problem.what());
        }
        HeightMapPicture& picture = *map.picture;
        if (saysExtent) {
            picture.centre = map.centre;
            picture.extent = map.extent;
        } else if (picture.extent == vec2(0.0f)) {
            io.fail("extent",
                    fmt::format("is missing; {} does not say how many metres it covers", picture.file.string()));
        }
        const WaterBody& water = scene_.water;
        const vec2 apart = glm::abs(picture.centre - water.centre), reach = 0.5f * (picture.extent + water.extent);
        if (water.present && glm::any(glm::greaterThanEqual(apart, reach)))
            io.fail("file",
                    fmt::format("covers none of the water: {} by {} m about ({}, {}); give another centre and extent",
                                picture.extent.x, picture.extent.y, picture.centre.x, picture.centre.y));
    }

    // ---- shapes

    int request(const std::filesystem::path& picture, TextureUse use, const std::string& origin, float bumpScale = 0.0f)
    {
        return textures_.request(scene_.file.parent_path() / picture, use, origin, bumpScale);
    }

    /// Names are how tables refer to each other: one thing each.
    void checkName(TableReader& io, const std::string& name, std::vector<std::string>& taken)
    {
        io.require({"name"});
        if (name.empty()) io.fail("name", "must not be empty");
        if (std::find(taken.begin(), taken.end(), name) != taken.end())
            io.fail("name", fmt::format("'{}' is already taken", name));
        taken.push_back(name);
    }

    void checkReference(TableReader& io, const char* key, const char* kind, const std::string& name,
                        const std::vector<std::string>& names)
    {
        if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
        const std::string nearest = nearestName(name, names);
        io.fail(key, fmt::format("names no {}: '{}'{}", kind, name,
                                 nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }

    void readMaterials()
    {
        for (const auto* table : root_.tables("materials")) {
            TableReader io = reader(*table, "materials");
            Material material;
            MaterialFiles files;
            keys(io, material, files);
            io.finish();
            checkName(io, material.name, materialNames_);
            const auto map = [&](const std::filesystem::path& picture, TextureUse use, const char* key, float scale) {
                return picture.empty() ? noImage : request(picture, use, io.place(key), scale);
            };
            material.diffuseMap = map(files.diffuse, TextureUse::colour, "diffuse_map", 0.0f);
            material.emissiveMap = map(files.emissive, TextureUse::colour, "emissive_map", 0.0f);
            material.alphaMap = map(files.alpha, TextureUse::alpha, "alpha_map", 0.0f);
            material.normalMap = map(files.normal, TextureUse::normal, "normal_map", 0.0f);
            if (!files.bump.empty() && !files.normal.empty())
                io.fail("bump_map", "excludes normal_map; give one or the other");
            if (!files.bump.empty()) {
                material.normalMap = map(files.bump, TextureUse::bump, "bump_map", files.bumpScale);
                material.bumpScale = files.bumpScale;
            }
            scene_.materials.push_back(std::move(material));
        }
    }

    void readModels()
    {
        for (const auto* table : root_.tables("models")) {
            TableReader io = reader(*table, "models");
            Model& model = scene_.models.emplace_back();
            keys(io, model);
            io.finish();
            checkName(io, model.name, shapeNames_);
            io.require({"file"});
            checkReference(io, "material", "material", model.material, materialNames_);
        }
    }

    void readPrimitives()
    {
        for (const auto* table : root_.tables("primitives")) {
            TableReader io = reader(*table, "primitives");
            Primitive& primitive = scene_.primitives.emplace_back();
            std::string material;
            keys(io, primitive, material);
            io.finish();
            checkName(io, primitive.name, shapeNames_);
            io.require({"kind"});
            if (primitive.kind == Primitive::Kind::sphere && !table->contains("segments")) primitive.segments = 32;
            checkReference(io, "material", "material", material, materialNames_);
            primitive.material = material.empty() ? greyMaterial() : indexOfMaterial(material);
        }
    }

    int indexOfMaterial(const std::string& name) const
    {
        const auto found = std::find(materialNames_.begin(), materialNames_.end(), name);
        return static_cast<int>(found - materialNames_.begin());
    }

    /// For primitives that name none.
    int greyMaterial()
    {
        if (grey_ < 0) {
            grey_ = static_cast<int>(scene_.materials.size());
            Material material;
            material.name = "grey";
            material.fromModel = true;
            scene_.materials.push_back(material);
        }
        return grey_;
    }

    // ---- elements

    void readElements()
    {
        for (const auto* table : root_.tables("elements")) scene_.elements.push_back(readElement(*table, 1));
    }

    Element readElement(const toml::table& table, int depth)
    {
        TableReader io = reader(table, "elements");
        Element element;
        keys(io, element);
        const auto children = io.tables("children");
        io.finish();
        checkReference(io, "shape", "model or primitive", element.shape, shapeNames_);
        if (element.scale.x == 0.0f || element.scale.y == 0.0f || element.scale.z == 0.0f)
            io.fail("scale", "must not be zero");
        if (depth == deepestElement && !children.empty())
            throw Error("{}: elements are nested more than {} deep", io.place(), deepestElement);
        for (const auto* child : children) element.children.push_back(readElement(*child, depth + 1));
        return element;
    }

    // ---- cameras

    void readCameras()
    {
        std::vector<std::string> names;
        for (const auto* table : root_.tables("cameras")) {
            TableReader io = reader(*table, "cameras");
            Camera& camera = scene_.cameras.emplace_back();
            keys(io, camera);
            io.finish();
            checkName(io, camera.name, names);
            checkCamera(io, camera);
        }
    }

    static void checkCamera(TableReader& io, const Camera& camera)
    {
        const vec3 forward = camera.target - camera.eye;
        const float length = glm::length(forward), upLength = glm::length(camera.up);
        if (!(length > 1e-6f)) io.fail("target", "must differ from the eye");
        if (!(upLength > 1e-6f) || !std::isfinite(upLength)) io.fail("up", "must not be zero");
        if (glm::length(glm::cross(forward / length, camera.up / upLength)) < 1e-4f)
            io.fail("up", "must not lie along the view; give another, such as [0, 0, -1]");
        if (camera.nearPlane >= camera.farPlane) io.fail("near", "must be smaller than far");
    }

    TableReader root_;
    std::string file_;
    TextureQueue& textures_;
    Scene scene_;
    std::vector<std::string> materialNames_, shapeNames_;
    int grey_ = -1;
};

} // namespace

Scene parseScene(const std::string& text, const std::filesystem::path& file, TextureQueue& textures)
{
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw Error("{}: the file is empty; a scene needs [[models]] or [[primitives]]", file.string());
    toml::table root;
    try {
        root = toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw Error("{}:{}: not valid TOML: {}", file.string(), error.source().begin.line, error.description());
    }
    return SceneParser(root, file, textures).parse();
}

} // namespace tarn

// saveScene: the TOML that loadScene reads back.
#include "scene/scene_file.h"

#include "base/error.h"
#include "base/files.h"
#include "scene/scene_keys.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tarn {

namespace {

namespace fs = std::filesystem;

/// A TOML basic string.
std::string tomlString(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 32 || c == 127) {
            result += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::string listed(const vec2& v) { return fmt::format("[{}, {}]", v.x, v.y); }
std::string listed(const vec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

/// Degrees with the digits that a float of radians can hold, so that 35° stays 35.
double degreesOf(float radians) { return std::round(glm::degrees(static_cast<double>(radians)) * 1e5) / 1e5; }

/// Collects "key = value" lines.
class TableWriter : public TableIo {
public:
    struct Line {
        std::string key, value;
    };
    std::vector<Line> lines;

    void number(const char* key, float& value, const KeyRange&) override { add(key, fmt::format("{}", value)); }
    void integer(const char* key, int& value, const KeyRange&) override { add(key, fmt::format("{}", value)); }
    void angle(const char* key, float& radians, const KeyRange&) override
    {
        add(key, fmt::format("{}", degreesOf(radians)));
    }
    void angles(const char* key, vec3& radians) override
    {
        add(key, fmt::format("[{}, {}, {}]", degreesOf(radians.x), degreesOf(radians.y), degreesOf(radians.z)));
    }
    void vector(const char* key, vec2& value, const KeyRange&) override { add(key, listed(value)); }
    void vector(const char* key, vec3& value, const KeyRange&) override { add(key, listed(value)); }
    void uniform(const char* key, vec2& value, const KeyRange&) override { add(key, listed(value)); }
    void uniform(const char* key, vec3& value, const KeyRange&) override { add(key, listed(value)); }
    void flag(const char* key, bool& value) override { add(key, value ? "true" : "false"); }
    void text(const char* key, std::string& value) override { add(key, tomlString(value)); }
    void path(const char* key, fs::path& value) override { add(key, tomlString(value.generic_string())); }
    void choiceIndex(const char* key, int& value, std::span<const char* const> names) override
    {
        add(key, tomlString(names[static_cast<std::size_t>(value)]));
    }

private:
    void add(const char* key, std::string value) { lines.push_back({key, std::move(value)}); }
};

class SceneWriter {
public:
    SceneWriter(const Scene& scene, const fs::path& file) : scene_(scene), folder_(fs::absolute(file).parent_path()) {}

    std::string write()
    {
        out_ += fmt::format("name = {}\n", tomlString(scene_.name));
        options();
        sun();
        sky();
        water();
        map("[maps.bed]", scene_.maps.bed);
        map("[maps.above_water]", scene_.maps.aboveWater);
        materials();
        for (Model model : scene_.models) {
            model.file = rebased(model.file);
            table("[[models]]", model, Model(), {"name", "file"});
        }
        primitives();
        for (const Element& element : scene_.elements) elementTree(element, "elements");
        for (const PointLight& light : scene_.pointLights) table("[[point_lights]]", light, PointLight(), {});
        for (const SpotLight& light : scene_.spotLights) table("[[spot_lights]]", light, SpotLight(), {});
        for (const Camera& camera : scene_.cameras) table("[[cameras]]", camera, Camera(), {"name", "eye", "target"});
        return std::move(out_);
    }

private:
    /// Lines that differ from the defaults, and those that must be there.
    void emit(const std::string& header, const TableWriter& actual, const TableWriter& defaults,
              std::initializer_list<std::string_view> always)
    {
        out_ += "\n" + header + "\n";
        for (std::size_t i = 0; i < actual.lines.size(); ++i) {
            const auto& line = actual.lines[i];
            const bool must = std::find(always.begin(), always.end(), line.key) != always.end();
            if (must || line.value != defaults.lines[i].value) out_ += fmt::format("{} = {}\n", line.key, line.value);
        }
    }

    template <typename T>
    void table(const std::string& header, T value, T defaultValue, std::initializer_list<std::string_view> always)
    {
        TableWriter actual, defaults;
        keys(actual, value);
        keys(defaults, defaultValue);
        emit(header, actual, defaults, always);
    }

    /// A path relative to where the scene came from, as one relative to where it goes.
    fs::path rebased(const fs::path& path) const
    {
        if (path.empty() || path.is_absolute()) return path;
        return relativeToTarget(fs::absolute(scene_.file).parent_path() / path);
    }

    fs::path relativeToTarget(const fs::path& absolute) const
    {
        const fs::path relative = absolute.lexically_normal().lexically_relative(folder_.lexically_normal());
        return relative.empty() ? absolute : relative;
    }

    fs::path pictureFile(int image) const
    {
        if (image == noImage) return {};
        return relativeToTarget(fs::absolute(scene_.images[static_cast<std::size_t>(image)].name));
    }

    void options()
    {
        if (scene_.options.empty()) return;
        out_ += "\n[options]\n";
        for (const Assignment& option : scene_.options)
            out_ += fmt::format("{} = {}\n", option.key, optionValue(option.value));
    }

    static std::string optionValue(const std::string& value)
    {
        if (value == "true" || value == "false") return value;
        // A number that TOML and we agree on stays bare; anything else is safe as a string.
        double number = 0.0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
        const bool whole = error == std::errc() && end == value.data() + value.size();
        return whole && fmt::format("{}", number) == value ? value : tomlString(value);
    }

    void sun()
    {
        if (!scene_.sun) return;
        out_ += fmt::format("\n[sun]\ndirection = {}\nirradiance = {}\n", listed(scene_.sun->direction),
                            scene_.sun->automatic ? "\"auto\"" : listed(scene_.sun->irradiance));
    }

    void sky()
    {
        Sky value = scene_.sky;
        value.file = rebased(value.file);
        table("[sky]", value, Sky(), {"kind"});
    }

    void water()
    {
        if (!scene_.water.present) return;
        WaterBody water = scene_.water;
        WaterNormalMap& map = water.normalMap;
        if (map.file.empty()) map = {}; // its other keys would be refused
        map.file = rebased(map.file);
        table("[water]", water, WaterBody(), {"level", "extent"});
        for (const Wave& wave : scene_.water.waves)
            table("[[water.waves]]", wave, Wave(), {"amplitude", "wavelength", "direction"});
        if (map.file.empty()) return;
        for (const WaterNormalMap::Layer& layer : map.layers)
            table("[[water.normal_layers]]", layer, WaterNormalMap::Layer(), {"velocity"});
    }

    void map(const std::string& header, GivenMap map)
    {
        if (map.file.empty()) return;
        map.file = rebased(map.file);
        map.picture.reset();                                                    // it stays in its file
        if (map.extent == vec2(0.0f)) return table(header, map, map, {"file"}); // no other key was there
        table(header, map, GivenMap(), {"file", "centre", "extent"});
    }

    void materials()
    {
        for (Material material : scene_.materials) {
            if (material.fromModel) continue;
            Material defaultMaterial;
            MaterialFiles files, defaultFiles;
            files.diffuse = pictureFile(material.diffuseMap);
            files.emissive = pictureFile(material.emissiveMap);
            files.alpha = pictureFile(material.alphaMap);
            const bool isBump = material.bumpScale != 0.0f;
            (isBump ? files.bump : files.normal) = pictureFile(material.normalMap);
            if (isBump) files.bumpScale = material.bumpScale;
            TableWriter actual, defaults;
            keys(actual, material, files);
            keys(defaults, defaultMaterial, defaultFiles);
            emit("[[materials]]", actual, defaults, {"name"});
        }
    }

    void primitives()
    {
        for (Primitive primitive : scene_.primitives) {
            const Material& material = scene_.materials.at(static_cast<std::size_t>(primitive.material));
            std::string materialName = material.fromModel ? "" : material.name, none;
            Primitive defaultPrimitive;
            TableWriter actual, defaults;
            keys(actual, primitive, materialName);
            keys(defaults, defaultPrimitive, none);
            emit("[[primitives]]", actual, defaults, {"name", "kind", "size", "segments"});
        }
    }

    void elementTree(const Element& element, const std::string& path)
    {
        table("[[" + path + "]]", element, Element(), {"name"});
        for (const Element& child : element.children) elementTree(child, path + ".children");
    }

    const Scene& scene_;
    fs::path folder_;
    std::string out_;
};

} // namespace

void saveScene(const Scene& scene, const fs::path& file) { writeFile(file, SceneWriter(scene, file).write()); }

} // namespace tarn

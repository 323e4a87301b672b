#include "scene/mtl_file.h"

#include "base/files.h"
#include "scene/text_scan.h"
#include "scene/warnings.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace tarn {

namespace {

/// One map statement: tinyobjloader takes the file name of "-s 2 2 wall.png" for a number, so these are read
/// here.
struct MapStatement {
    std::string file;
    std::size_t line = 0;
    float multiplier = 1.0f; ///< -bm
};

struct MaterialMaps {
    std::optional<MapStatement> diffuse, emissive, alpha, bump, normal;
    bool hasDiffuse = false; ///< there is a Kd
};

float numberOr(std::string_view word, float fallback)
{
    return isNumber(word) ? std::strtof(std::string(word).c_str(), nullptr) : fallback;
}

/// "-bm 0.5 -s 2 2 -clamp on old wall.png": options, then a name that may hold blanks.
MapStatement parseMap(std::string_view rest, std::size_t line)
{
    struct Option {
        std::string_view name;
        int least, most; ///< arguments; those after the least only while they are numbers
    };
    static constexpr std::array<Option, 13> options{{{"-s", 1, 3},
                                                     {"-o", 1, 3},
                                                     {"-t", 1, 3},
                                                     {"-bm", 1, 1},
                                                     {"-mm", 2, 2},
                                                     {"-blendu", 1, 1},
                                                     {"-blendv", 1, 1},
                                                     {"-clamp", 1, 1},
                                                     {"-cc", 1, 1},
                                                     {"-imfchan", 1, 1},
                                                     {"-texres", 1, 1},
                                                     {"-boost", 1, 1},
                                                     {"-type", 1, 1}}};
    MapStatement map;
    map.line = line;
    for (;;) {
        std::string_view after = rest;
        const auto word = nextWord(after);
        const auto* option =
            std::find_if(options.begin(), options.end(), [&](const Option& o) { return o.name == word; });
        if (option == options.end()) break;
        rest = after;
        for (int i = 0; i < option->most; ++i) {
            after = rest;
            const auto argument = nextWord(after);
            if (i >= option->least && !isNumber(argument)) break;
            if (option->name == "-bm") map.multiplier = numberOr(argument, 1.0f);
            rest = after;
        }
    }
    map.file = trimBlanks(rest);
    std::replace(map.file.begin(), map.file.end(), '\\', '/');
    return map;
}

/// Reads what tinyobjloader would not, and comments out what it must not see.
class MtlScanner {
public:
    MtlScanner(std::string& text, FileWarnings& warnings) : text_(text), warnings_(warnings) {}

    /// Maps per material, in file order.
    std::vector<MaterialMaps> run()
    {
        for (std::size_t begin = 0; begin < text_.size(); ++line_) {
            const std::size_t end = std::min(text_.find('\n', begin), text_.size());
            scanLine(begin, end);
            begin = end + 1;
        }
        return std::move(maps_);
    }

private:
    void scanLine(std::size_t begin, std::size_t end)
    {
        std::string_view rest(text_.data() + begin, end - begin);
        const auto word = nextWord(rest);
        if (word.empty() || word[0] == '#') return;
        if (word == "newmtl") {
            if (trimBlanks(rest).empty()) return drop(begin);
            maps_.emplace_back();
        } else if (maps_.empty()) {
            drop(begin); // before the first newmtl: belongs to nothing
        } else if (isMap(word)) {
            readMap(word, rest);
            drop(begin);
        } else if (const int count = numberCount(word); count > 0) {
            if (!checkNumbers(word, rest)) return drop(begin);
            if (word == "Kd") maps_.back().hasDiffuse = true;
        } else {
            drop(begin); // illum, Ni, sharpness …: nothing here uses them
        }
    }

    static int numberCount(std::string_view word)
    {
        if (word == "Kd" || word == "Ks" || word == "Ke" || word == "Tf") return 3;
        return word == "Ns" || word == "d" || word == "Tr" ? 1 : 0;
    }

    static bool isMap(std::string_view word)
    {
        return word.starts_with("map_") || word == "bump" || word == "norm" || word == "disp" || word == "refl";
    }

    bool checkNumbers(std::string_view word, std::string_view rest)
    {
        if (word == "d") {
            std::string_view after = rest;
            if (nextWord(after) == "-halo") return false;
        }
        for (int i = 0; i < numberCount(word); ++i) {
            const auto value = nextWord(rest);
            if (isNumber(value)) continue;
            warnings_.at(line_, fmt::format("{} needs {} finite number{}; left out", word, numberCount(word),
                                            numberCount(word) > 1 ? "s" : ""));
            return false;
        }
        return true;
    }

    void readMap(std::string_view word, std::string_view rest)
    {
        MapStatement map = parseMap(rest, line_);
        if (map.file.empty()) return warnings_.at(line_, fmt::format("{} names no picture; left out", word));
        MaterialMaps& maps = maps_.back();
        if (word == "map_Kd") maps.diffuse = map;
        if (word == "map_Ke") maps.emissive = map;
        if (word == "map_d") maps.alpha = map;
        if (word == "map_Bump" || word == "map_bump" || word == "bump") maps.bump = map;
        if (word == "norm" || word == "map_Kn") maps.normal = map;
    }

    void drop(std::size_t begin)
    {
        while (isBlank(text_[begin])) ++begin;
        text_[begin] = '#';
    }

    std::string& text_;
    FileWarnings& warnings_;
    std::size_t line_ = 1;
    std::vector<MaterialMaps> maps_;
};

vec3 nonNegative(const tinyobj::real_t (&rgb)[3], float most)
{
    return glm::clamp(vec3(rgb[0], rgb[1], rgb[2]), vec3(0.0f), vec3(most));
}

Material convert(const tinyobj::material_t& source)
{
    Material material;
    material.name = trimBlanks(source.name);
    material.fromModel = true;
    material.diffuse = nonNegative(source.diffuse, 1.0f);
    material.specular = nonNegative(source.specular, 1.0f);
    material.transmission = nonNegative(source.transmittance, 1.0f);
    material.emissive = nonNegative(source.emission, 1e6f);
    material.shininess = std::clamp(static_cast<float>(source.shininess), 1.0f, 10000.0f);
    material.alpha = std::clamp(static_cast<float>(source.dissolve), 0.0f, 1.0f);
    return material;
}

/// Asks for the pictures of a material and fills in what it leaves open beside them.
void applyMaps(Material& material, const MaterialMaps& maps, const std::filesystem::path& file, TextureQueue& textures)
{
    const auto request = [&](const MapStatement& map, TextureUse use, float bumpScale = 0.0f) {
        return textures.request(file.parent_path() / map.file, use, fmt::format("{}:{}", file.string(), map.line),
                                bumpScale);
    };
    if (!maps.hasDiffuse) material.diffuse = maps.diffuse ? vec3(1.0f) : Material().diffuse;
    if (maps.emissive && material.emissive == vec3(0.0f)) material.emissive = vec3(1.0f);
    if (maps.diffuse) material.diffuseMap = request(*maps.diffuse, TextureUse::colour);
    if (maps.emissive) material.emissiveMap = request(*maps.emissive, TextureUse::colour);
    if (maps.alpha) material.alphaMap = request(*maps.alpha, TextureUse::alpha);
    if (maps.normal) {
        material.normalMap = request(*maps.normal, TextureUse::normal);
    } else if (maps.bump && maps.bump->multiplier != 0.0f) {
        material.bumpScale = maps.bump->multiplier;
        material.normalMap = request(*maps.bump, TextureUse::bump, material.bumpScale);
    }
}

} // namespace

const MaterialNames& MtlLibrary::materialsOf(const std::filesystem::path& file)
{
    const auto path = file.lexically_normal();
    const auto found = known_.find(path);
    return found != known_.end() ? found->second : known_.emplace(path, read(path)).first->second;
}

MaterialNames MtlLibrary::read(const std::filesystem::path& file)
{
    std::string text = readFile(file);
    normaliseLines(text);
    std::replace(text.begin(), text.end(), '\0', ' ');
    FileWarnings warnings(file.string());
    const std::vector<MaterialMaps> allMaps = MtlScanner(text, warnings).run();
    MaterialNames names;
    if (allMaps.empty()) {
        warnings.at(1, "no material in this file; is it a Wavefront MTL file?");
        return names;
    }

    std::istringstream stream(text);
    std::map<std::string, int> ignored;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    tinyobj::LoadMtl(&ignored, &materials, &stream, &warning, &error);
    for (std::size_t i = 0; i < std::min(materials.size(), allMaps.size()); ++i) {
        Material material = convert(materials[i]);
        if (!names.emplace(material.name, static_cast<int>(scene_.materials.size())).second) continue;
        applyMaps(material, allMaps[i], file, textures_);
        scene_.materials.push_back(std::move(material));
    }
    return names;
}

} // namespace tarn

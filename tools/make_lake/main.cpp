// make_lake: draws the lake that Tarn ships with. Equal seeds give equal files.

#include "base/error.h"
#include "base/files.h"
#include "obj_file.h"
#include "pier.h"
#include "plants.h"
#include "refine.h"
#include "rocks.h"
#include "scene_text.h"
#include "terrain.h"
#include "textures.h"
#include "woods.h"

#include <charconv>
#include <cstdio>
#include <iostream>
#include <optional>

namespace tarn::lake {

namespace {

constexpr std::uint32_t shippedSeed = 7;
constexpr const char* usage = "usage: make_lake --out FOLDER [--seed NUMBER] [--scale 1|4|16|64]";

struct Arguments {
    std::filesystem::path out;
    std::uint32_t seed = shippedSeed;
    int scale = 1; ///< times the shipped lake's triangles
};

/// The whole of a word as a number; nothing when it is none.
template <typename Number> std::optional<Number> numberOf(std::string_view word)
{
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
}

Arguments parse(int count, char** words)
{
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = words[i];
        if ((word != "--out" && word != "--seed" && word != "--scale") || i + 1 == count)
            throw UsageError("'{}': {}; {}", word,
                             i + 1 == count ? "a value is missing or the word is unknown" : "unknown", usage);
        const std::string_view value = words[++i];
        if (word == "--out") {
            arguments.out = value;
        } else if (word == "--seed") {
            const auto seed = numberOf<std::uint32_t>(value);
            if (!seed) throw UsageError("--seed {}: not a whole number from 0 to 4294967295; {}", value, usage);
            arguments.seed = *seed;
        } else {
            const auto scale = numberOf<int>(value);
            if (scale != 1 && scale != 4 && scale != 16 && scale != 64)
                throw UsageError("--scale {}: not 1, 4, 16 or 64; {}", value, usage);
            arguments.scale = *scale;
        }
    }
    if (arguments.out.empty()) throw UsageError("--out is missing; {}", usage);
    return arguments;
}

/// Adds what was made to the folder, and to the sums that are told at the end.
class Output {
public:
    Output(std::filesystem::path folder, Refinement refinement) : folder_(std::move(folder)), refinement_(refinement) {}

    /// Where a new vertex of a refined mesh stands.
    using Settle = std::function<vec3(const vec3& position)>;

    void write(const Mesh& coarse, const std::string& name, std::size_t copies = 1, const Settle& settle = {})
    {
        // What carpenters make is smooth.
        const float roughness = name == "pier" || name == "boat" ? 0.004f : 0.03f;
        const Mesh mesh = refined(coarse, refinement_, roughness, settle);
        writeObj(folder_ / (name + ".obj"), mesh, name);
        vertices_ += mesh.positions.size();
        faces_ += mesh.faces.size();
        drawn_ += mesh.triangles() * copies;
        std::cerr << fmt::format("{:14} {:7} vertices {:7} faces {:4} x {:6} triangles\n", name, mesh.positions.size(),
                                 mesh.faces.size(), copies, mesh.triangles());
    }
    void summary() const
    {
        std::cerr << fmt::format("{:14} {:7} vertices {:7} faces, {} triangles drawn\n", "together", vertices_, faces_,
                                 drawn_);
    }

private:
    std::filesystem::path folder_;
    Refinement refinement_;
    std::size_t vertices_ = 0, faces_ = 0, drawn_ = 0;
};

/// Everything but the trees that keeps the sky from the ground.
std::vector<Shade> otherShades(const std::vector<Boulder>& boulders, const PierSite& site)
{
    std::vector<Shade> shades;
    for (const Boulder& boulder : boulders)
        shades.push_back({{boulder.centre.x, boulder.centre.z}, 1.7f * boulder.radii.x, 0.6f});
    for (float along = 0.0f; along < site.length; along += 0.7f) shades.push_back({site.at(along, 0.0f), 1.6f, 0.22f});
    const vec3 boat(boatPlace(site)[3]), bow(boatPlace(site) * vec4(1.2f, 0, 0, 1)),
        stern(boatPlace(site) * vec4(-1.2f, 0, 0, 1));
    for (const vec3& p : {boat, bow, stern}) shades.push_back({{p.x, p.z}, 1.5f, 0.25f});
    return shades;
}

void writePlants(Output& output, const LakeShape& shape, const std::vector<View>& cameras,
                 const std::vector<Species>& species, const std::filesystem::path& textures, std::uint32_t seed)
{
    const FoliageTextures foliage = drawFoliage(seed);
    writeFoliageTextures(textures, foliage);
    std::vector<const Mesh*> far;
    for (const std::size_t kind : {0u, 1u, 2u, 3u, 5u, 6u, 7u, 8u}) far.push_back(&species[kind].mesh);
    const Impostors impostors = drawImpostors(far, foliage);
    writePngWithAlpha(textures / "forest_trees.png", impostors.picture);

    output.write(makeReeds(shape, cameras, Random(seed, 2)), "reeds");
    output.write(makeGrass(shape, cameras, Random(seed, 3)), "grass");
    output.write(makeWeed(shape, cameras, Random(seed, 4)), "weed");
    output.write(makeForest(shape, impostors, cameras, Random(seed, 5)), "forest");
}

void make(const Arguments& arguments)
{
    const std::filesystem::path textures = arguments.out / "textures";
    std::error_code failed;
    std::filesystem::create_directories(textures, failed);
    if (failed) throw Error("{}: cannot make the folder: {}", textures.string(), failed.message());

    const std::uint32_t seed = arguments.seed;
    const LakeShape shape(seed);
    const PierSite site = pierSite(shape);
    const std::vector<View> cameras = views(shape);
    const std::vector<Boulder> boulders = placeBoulders(shape, cameras, Random(seed, 6));
    const std::vector<Species> species = growSpecies(seed);
    const std::vector<StandingTree> trees = plantTrees(shape, species, cameras, Random(seed, 7));

    std::vector<Shade> shades = treeShades(trees, species);
    for (const Shade& shade : otherShades(boulders, site)) shades.push_back(shade);

    Output output(arguments.out, Refinement::times(arguments.scale));
    output.write(makeTerrain(shape, shades, seed + 8), "terrain", 1, [&](const vec3& p) {
        return shape.onGround({p.x, p.z});
    });
    output.write(makeMountains(seed + 9), "mountains");
    output.write(makeBoulders(boulders, shape, seed + 10), "boulders");
    output.write(makeStones(shape, Random(seed, 11)), "stones");
    output.write(makeSunkenTrunk(shape, Random(seed, 12)), "trunk");
    Mesh pier = makePier(shape, site, Random(seed, 13));
    pier.append(makeRope(site), mat4(1.0f));
    output.write(pier, "pier");
    output.write(makeBoat(Random(seed, 14)), "boat");
    writePlants(output, shape, cameras, species, textures, seed);
    for (std::size_t kind = 0; kind < species.size(); ++kind) {
        std::size_t copies = 0;
        for (const StandingTree& tree : trees) copies += tree.species == kind ? 1u : 0u;
        output.write(species[kind].mesh, species[kind].name, copies);
    }
    writeMaterials(arguments.out);
    writeGroundTextures(textures, seed);
    writeWoodTextures(textures, seed);

    SceneParts parts{.placedModels = {"terrain", "mountains", "boulders", "stones", "trunk", "pier", "reeds", "grass",
                                      "weed", "forest"},
                     .species = &species,
                     .trees = &trees,
                     .views = &cameras,
                     .worldFromBoat = boatPlace(site)};
    parts.boatTurn = std::atan2(-parts.worldFromBoat[0].z, parts.worldFromBoat[0].x);
    writeFile(arguments.out / "lake.toml", sceneText(parts, Random(seed, 15)));
    output.summary();
}

} // namespace

} // namespace tarn::lake

int main(int argumentCount, char** arguments)
{
    try {
        tarn::lake::make(tarn::lake::parse(argumentCount, arguments));
        return 0;
    } catch (const tarn::UsageError& error) {
        std::cerr << "make_lake: error: " << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "make_lake: error: " << error.what() << '\n';
        return 1;
    }
}

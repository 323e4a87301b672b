// tarn maps: what rays are marched through, as pictures that a scene file can name.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/session.h"
#include "app/version.h"
#include "base/error.h"
#include "base/files.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tarn {

namespace {

/// Straight over the water and all of it in the picture, so that both maps are asked for.
Camera overWater(const WaterBody& water)
{
    const float height = std::max(water.extent.x, water.extent.y) + 2.0f * totalAmplitude(water);
    Camera camera;
    camera.name = "maps";
    camera.target = {water.centre.x, water.level, water.centre.y};
    camera.eye = camera.target + vec3(0.0f, height, 0.0f);
    camera.up = {0.0f, 0.0f, -1.0f};
    camera.farPlane = 2.0f * height;
    camera.nearPlane = 1.0e-3f * height;
    return camera;
}

/// A frame that marches through both maps, and draws them: none that the scene has from outside.
void requireBothMaps(SceneSetup& sceneSetup)
{
    sceneSetup.scene.maps = {};
    Options& options = sceneSetup.settings.options;
    options.refraction.enabled = options.reflection.enabled = options.water.reflects = true;
    options.refraction.method = RefractionOptions::Method::raycast;
    options.reflection.method = ReflectionOptions::Method::raycast;
    options.stereo.output = StereoOptions::Output::off;
}

} // namespace

void run(const MapsCommand& command)
{
    requireWritableJson(command.json);
    makeFolder(command.out);
    requireWritableFolder(command.out);
    TerminalProgress progress;
    SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    if (!sceneSetup.settings.water.present || !sceneSetup.settings.options.water.enabled)
        throw Error("{}: has no water, and maps of heights are of what lies under it and stands over it",
                    sceneSetup.scene.file.string());
    requireBothMaps(sceneSetup);

    constexpr ivec2 any(64); // the maps' own size is heights.map_size
    Session session(sceneSetup, any, &progress);
    const Camera camera = overWater(sceneSetup.settings.water);
    session.renderer().render({camera, 0.0, any});
    nlohmann::json files = nlohmann::json::array();
    for (const MapKind kind : {MapKind::bed, MapKind::aboveWater}) {
        const std::optional<HeightMapPicture> map = session.renderer().readMap(kind);
        if (!map) throw Error("{}: the map '{}' was not drawn", sceneSetup.scene.file.string(), mapName(kind));
        const std::filesystem::path file = command.out / fmt::format("{}.exr", mapName(kind));
        writeMapPicture(file, *map,
                        {{"tarn:version", versionText()},
                         {"tarn:scene", sceneSetup.scene.file.filename().string()},
                         {"tarn:settings", settingsJson(sceneSetup.settings)}});
        files.push_back({{"map", mapName(kind)},
                         {"file", file.string()},
                         {"resolution", map->resolution},
                         {"centre", {map->centre.x, map->centre.y}},
                         {"extent", {map->extent.x, map->extent.y}}});
    }
    writeJson(command.json, {{"scene", sceneSetup.scene.file.string()}, {"maps", files}});
    if (command.json == "-") return;
    for (const nlohmann::json& file : files) fmt::print("{}\n", file.at("file").get<std::string>());
}

MakeCommand defineMaps(Flags& flags)
{
    auto command = std::make_shared<MapsCommand>();
    addSceneFlags(flags, command->scene);
    flags.path("--out", "DIR", "Folder of bed.exr and above_water.exr; made when it is not there", command->out);
    flags.json(command->json);
    return [command]() -> Command {
        if (command->out.empty()) throw UsageError("maps needs --out DIR, a folder for bed.exr and above_water.exr");
        return *command;
    };
}

} // namespace tarn

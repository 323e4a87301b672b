// tarn info: what this program, machine and scene are.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/scene_setup.h"
#include "app/version.h"
#include "base/error.h"
#include "gl/context.h"
#include "gl/workarounds.h"

#include <nlohmann/json.hpp>

namespace tarn {

namespace {

nlohmann::json workaroundsJson()
{
    nlohmann::json active = nlohmann::json::object();
    for (const gl::Workaround& workaround : gl::workarounds())
        if (workaround.active) active[workaround.name] = workaround.reason;
    return active;
}

/// A machine without OpenGL is told, not failed at: that is what one asks `tarn info` for.
nlohmann::json machineJson()
{
    try {
        const auto context = gl::makeHeadlessContext({16, 16});
        const gl::Capabilities& limits = gl::capabilities();
        return {{"devices", gl::headlessDevices()},  {"device", context->device()},
                {"renderer", context->renderer()},   {"opengl", context->version()},
                {"software", context->isSoftware()}, {"max_texture_size", limits.maxTextureSize},
                {"max_samples", limits.maxSamples},  {"max_anisotropy", limits.maxAnisotropy},
                {"workarounds", workaroundsJson()}};
    } catch (const Error& error) {
        return {{"renderer", nullptr}, {"problem", error.what()}};
    }
}

nlohmann::json sceneJson(const Scene& scene)
{
    std::size_t vertices = 0, faces = 0, chunks = 0, placedFaces = 0;
    for (const Mesh& mesh : scene.meshes) {
        vertices += mesh.vertices.size();
        faces += mesh.indices.size() / 3;
        chunks += mesh.parts.size();
    }
    const std::vector<Instance> instances = flatten(scene);
    for (const Instance& instance : instances)
        placedFaces += scene.meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    nlohmann::json cameras = nlohmann::json::array();
    for (const Camera& camera : scene.cameras) cameras.push_back(camera.name);
    return {{"file", scene.file.string()},
            {"name", scene.name},
            {"vertices", vertices},
            {"faces", faces},
            {"instances", instances.size()},
            {"faces_placed", placedFaces},
            {"chunks", chunks},
            {"materials", scene.materials.size()},
            {"images", scene.images.size()},
            {"lights", (scene.sun ? 1u : 0u) + scene.pointLights.size() + scene.spotLights.size()},
            {"water", scene.water.present},
            {"waves", scene.water.waves.size()},
            {"cameras", cameras}};
}

void printSection(const char* title, const nlohmann::json& section)
{
    fmt::print("{}\n", title);
    for (const auto& [key, value] : section.items())
        fmt::print("  {:<18}{}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
}

} // namespace

void run(const InfoCommand& command)
{
    requireWritableJson(command.json);
    nlohmann::json info;
    info["program"] = {{"version", versionText()}, {"build", buildText()}};
    info["machine"] = machineJson();
    {
        TerminalProgress progress;
        info["scene"] = sceneJson(loadSceneSetup(command.scene, &progress).scene);
    }
    writeJson(command.json, info);
    if (command.json == "-") return;
    for (const char* section : {"program", "machine", "scene"}) printSection(section, info[section]);
}

MakeCommand defineInfo(Flags& flags)
{
    auto command = std::make_shared<InfoCommand>();
    addSceneFlags(flags, command->scene);
    flags.json(command->json);
    return [command] { return *command; };
}

} // namespace tarn

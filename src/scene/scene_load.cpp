// loadScene: TOML, or a bare OBJ.
#include "scene/scene_file.h"

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "scene/obj_file.h"
#include "scene/primitives.h"
#include "scene/scene_defaults.h"
#include "scene/scene_toml.h"
#include "scene/textures.h"

#include <algorithm>
#include <cctype>

namespace tarn
{

namespace
{

namespace fs = std::filesystem;

void report(Progress* progress, double fraction, const std::string& what)
{
    if (progress) progress->report(fraction, what);
}

int materialIndex(const Scene& scene, const std::string& name)
{
    const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                    [&](const Material& material) { return material.name == name; });
    return found == scene.materials.end() ? -1 : static_cast<int>(found - scene.materials.begin());
}

/// Models that cannot be read are left out with a warning while something else is left to draw.
void readModels(Scene& scene, TextureQueue& textures, Progress* progress)
{
    MtlLibrary libraries(scene, textures);
    std::string firstProblem;
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        Model& model = scene.models[i];
        report(progress, 0.5 * static_cast<double>(i) / static_cast<double>(scene.models.size()),
               "reading " + model.file.filename().string());
        const int material = model.material.empty() ? -1 : materialIndex(scene, model.material);
        try {
            Mesh mesh = readObj(scene.file.parent_path() / model.file, scene, libraries, material);
            mesh.name = model.name;
            model.mesh = static_cast<int>(scene.meshes.size());
            scene.meshes.push_back(std::move(mesh));
        } catch (const Error& problem) {
            if (scene.models.size() + scene.primitives.size() == 1) throw;
            log::warning("{}; drawn without the model '{}'", problem.what(), model.name);
            if (firstProblem.empty()) firstProblem = problem.what();
        }
    }
    if (scene.meshes.empty() && scene.primitives.empty() && !firstProblem.empty()) throw Error(firstProblem);
}

void buildPrimitives(Scene& scene)
{
    for (Primitive& primitive : scene.primitives) {
        primitive.mesh = static_cast<int>(scene.meshes.size());
        scene.meshes.push_back(buildPrimitive(primitive));
    }
}

/// Everything once, where it is.
void placeEverything(Scene& scene)
{
    const auto place = [&](const std::string& shape) {
        Element element;
        element.name = shape;
        element.shape = shape;
        scene.elements.push_back(std::move(element));
    };
    for (const Model& model : scene.models)
        place(model.name);
    for (const Primitive& primitive : scene.primitives)
        place(primitive.name);
}

void checkSky(Scene& scene)
{
    if (scene.sky.kind != Sky::Kind::picture || scene.sky.image != noImage) return;
    log::warning("{}: the sky's picture is missing; the daylight model stands in for it",
                 scene.file.string());
    scene.sky.kind = Sky::Kind::daylight;
}

/// Reads what the scene names and adds what it leaves open.
void complete(Scene& scene, TextureQueue& textures, const LoadOptions& options)
{
    readModels(scene, textures, options.progress);
    buildPrimitives(scene);
    if (scene.elements.empty()) placeEverything(scene);
    textures.decodeInto(scene, options.progress);
    checkSky(scene);

    const Bounds bounds = worldBounds(scene);
    if (bounds.empty())
        throw Error("{}: nothing to draw, no visible element has a shape", scene.file.string());
    if (scene.cameras.empty()) scene.cameras = camerasAround(bounds);
    if (options.waterLevel) {
        if (!scene.water.present) scene.water = waterAcross(bounds, *options.waterLevel);
        scene.water.level = *options.waterLevel;
    }
    report(options.progress, 1.0, "ready");
}

Scene loadObjScene(const fs::path& file, const LoadOptions& options)
{
    Scene scene;
    scene.name = file.stem().string();
    scene.file = file;
    Model model;
    model.name = scene.name;
    model.file = file.filename();
    scene.models.push_back(model);

    Sun sun;
    sun.direction =
        glm::normalize(vec3(0.4f, 0.7f, 0.45f)); // 49° high, from behind the overview camera's shoulder
    scene.sun = sun;
    // Daylight is some tens of klx; a tenth brings a grey wall near the middle of the tone curve.
    scene.options.push_back({"frame.exposure", "0.1", file.string()});

    TextureQueue textures;
    complete(scene, textures, options);
    if (!options.waterLevel) {
        const Bounds bounds = worldBounds(scene);
        if (const auto level = levelWithin(bounds)) scene.water = waterAcross(bounds, *level);
    }
    return scene;
}

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

} // namespace

Scene loadScene(const fs::path& file, const LoadOptions& options)
{
    const std::string extension = lowerCase(file.extension().string());
    std::error_code error;
    const bool isFile = fs::exists(file, error) && !fs::is_directory(file, error);
    if (isFile && extension != ".obj" && extension != ".toml")
        throw Error("{}: a scene is a .toml or a .obj file", file.string());
    if (isFile && extension == ".obj") return loadObjScene(file, options);

    const std::string text = readFile(file); // says what is wrong with a missing file or a directory
    TextureQueue textures;
    Scene scene = parseScene(text, file, textures);
    complete(scene, textures, options);
    return scene;
}

} // namespace tarn

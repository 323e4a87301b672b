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

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tarn {

namespace {

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

/// What the models' files give, side by side on every core.
class ModelFiles {
public:
    ModelFiles(const Scene& scene, Progress* progress)
        : scene_(scene), progress_(progress), states_(scene.models.size())
    {}

    void readTexts()
    {
        forEach("reading ", [&](State& state, const Model& model) {
            state.file = std::make_unique<ObjFile>(scene_.file.parent_path() / model.file);
        });
    }

    /// One after the other: models share libraries.
    void findMaterials(MtlLibrary& libraries)
    {
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const Model& model = scene_.models[i];
            if (states_[i].problem) continue;
            states_[i].file->findMaterials(libraries,
                                           model.material.empty() ? -1 : materialIndex(scene_, model.material));
        }
    }

    void buildMeshes()
    {
        forEach("building ", [](State& state, const Model& model) {
            state.mesh = state.file->build();
            state.mesh.name = model.name;
            state.file.reset();
        });
    }

    /// Throws what went wrong with the model's file.
    Mesh take(std::size_t model)
    {
        if (states_[model].problem) std::rethrow_exception(states_[model].problem);
        return std::move(states_[model].mesh);
    }

private:
    struct State {
        std::unique_ptr<ObjFile> file;
        Mesh mesh;
        std::exception_ptr problem;
    };

    /// Each of the two goes through a quarter of the bar; pictures have the rest.
    template <typename Step> void forEach(const std::string& what, const Step& step)
    {
        tbb::parallel_for(std::size_t{0}, states_.size(), [&](std::size_t i) {
            State& state = states_[i];
            if (state.problem) return;
            try {
                step(state, scene_.models[i]);
            } catch (...) {
                state.problem = std::current_exception();
            }
            const std::lock_guard lock(reporting_);
            ++done_;
            report(progress_, 0.25 * static_cast<double>(done_) / static_cast<double>(states_.size()),
                   what + scene_.models[i].file.filename().string());
        });
    }

    const Scene& scene_;
    Progress* progress_;
    std::vector<State> states_;
    std::mutex reporting_;
    std::size_t done_ = 0;
};

/// Models that cannot be read are left out with a warning while something else is left to draw.
void readModels(Scene& scene, TextureQueue& textures, Progress* progress)
{
    MtlLibrary libraries(scene, textures);
    ModelFiles files(scene, progress);
    files.readTexts();
    files.findMaterials(libraries);
    files.buildMeshes();
    std::string firstProblem;
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        Model& model = scene.models[i];
        try {
            Mesh mesh = files.take(i);
            addGrey(mesh, scene);
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
    for (const Model& model : scene.models) place(model.name);
    for (const Primitive& primitive : scene.primitives) place(primitive.name);
}

void checkSky(Scene& scene)
{
    if (scene.sky.kind != Sky::Kind::picture || scene.sky.image != noImage) return;
    log::warning("{}: the sky's picture is missing; the daylight model stands in for it", scene.file.string());
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
    if (bounds.empty()) throw Error("{}: nothing to draw, no visible element has a shape", scene.file.string());
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
    sun.direction = glm::normalize(vec3(0.4f, 0.7f, 0.45f)); // 49° high, from behind the overview camera's shoulder
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

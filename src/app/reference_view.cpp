#include "app/reference_view.h"

#include "base/error.h"
#include "base/log.h"
#include "measure/display.h"
#include "reference/identity.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace tarn {

namespace {

const std::string& headerText(const reference::Picture& picture, const char* key, const std::filesystem::path& file)
{
    const auto found = picture.metadata.find(key);
    if (found == picture.metadata.end())
        throw Error("{}: its header has no {}; make it with `tarn reference`", file.string(), key);
    return found->second;
}

vec3 vectorFrom(const nlohmann::json& json)
{
    return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

Camera cameraLike(const Scene& scene, const std::string& name)
{
    if (const Camera* camera = scene.findCamera(name)) return *camera;
    return scene.cameras.empty() ? Camera{} : scene.cameras.front();
}

} // namespace

ReferenceView referenceView(const reference::Picture& picture, const Scene& scene, const std::filesystem::path& file)
{
    const std::string& view = headerText(picture, "tarn:camera", file);
    const std::string& time = headerText(picture, "tarn:time", file);
    try {
        const nlohmann::json json = nlohmann::json::parse(view);
        Camera camera = cameraLike(scene, json.at("name").get<std::string>());
        camera.name = json.at("name").get<std::string>();
        camera.eye = vectorFrom(json.at("eye"));
        camera.target = vectorFrom(json.at("target"));
        camera.up = vectorFrom(json.at("up"));
        camera.verticalFov = glm::radians(json.at("vertical_fov_degrees").get<float>());
        camera.lensShift = json.value("lens_shift", 0.0f);
        return {camera, std::stod(time)};
    } catch (const std::exception& error) { // of JSON, or of the number
        throw Error("{}: its header's camera or time is damaged ({})", file.string(), error.what());
    }
}

bool isSameView(const Camera& a, const Camera& b)
{
    constexpr float position = 1.0e-4f, angle = 1.0e-5f; // m, and radians of any direction
    const auto forward = [](const Camera& c) { return glm::normalize(c.target - c.eye); };
    const auto right = [&](const Camera& c) { return glm::normalize(glm::cross(forward(c), c.up)); };
    return glm::distance(a.eye, b.eye) < position && glm::distance(forward(a), forward(b)) < angle &&
           glm::distance(right(a), right(b)) < angle && std::abs(a.verticalFov - b.verticalFov) < angle &&
           std::abs(a.lensShift - b.lensShift) < angle;
}

void requireSameScene(const reference::Picture& picture, const SceneSetup& sceneSetup,
                      const std::filesystem::path& file)
{
    const auto made = picture.metadata.find("tarn:scene_content");
    if (made == picture.metadata.end()) {
        log::warning("{}: does not tell which scene it shows; make it anew with `tarn reference`", file.string());
        return;
    }
    WaterBody water = sceneSetup.settings.water;
    water.present = water.present && sceneSetup.settings.options.water.enabled;
    const std::string difference =
        reference::sceneDifference(made->second, reference::sceneIdentity(sceneSetup.scene, water));
    if (!difference.empty())
        throw Error("{}: shows another scene than {}: {} differ; make it anew with `tarn reference`", file.string(),
                    sceneSetup.scene.file.string(), difference);
}

Image linearPicture(const reference::Picture& picture)
{
    Image image;
    image.name = "reference";
    image.width = picture.size.x;
    image.height = picture.size.y;
    image.channels = 3;
    image.floats.reserve(image.size());
    for (const vec3& radiance : picture.radiance)
        image.floats.insert(image.floats.end(), {radiance.x, radiance.y, radiance.z});
    return image;
}

Image displayPicture(const reference::Picture& picture, const FrameOptions& options)
{
    return displayPicture(exposedPicture(linearPicture(picture), options.exposure), options.toneCurve);
}

} // namespace tarn

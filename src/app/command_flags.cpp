#include "app/command_flags.h"

#include "app/parse.h"

#include <CLI/CLI.hpp>

namespace tarn {

void Flags::value(const std::string& flag, const char* what, const char* doc, Convert convert)
{
    auto text = std::make_shared<std::string>();
    CLI::Option* option = app_.add_option(flag, *text, doc)->type_name(what);
    finally([=] {
        if (option->count() > 0) convert(*text, flag);
    });
}

void Flags::text(const std::string& flag, const char* what, const char* doc, std::string& value)
{
    app_.add_option(flag, value, doc)->type_name(what);
}

void Flags::path(const std::string& flag, const char* what, const char* doc, std::filesystem::path& value)
{
    this->value(flag, what, doc, [&value](const std::string& text, const std::string&) { value = text; });
}

void Flags::optionalText(const std::string& flag, const char* what, const char* doc, std::string& value,
                         const char* whenLeftOut)
{
    CLI::Option* option = app_.add_option(flag, value, doc)->type_name(what)->expected(0, 1);
    finally([option, &value, whenLeftOut] {
        if (option->count() > 0 && value.empty()) value = whenLeftOut;
    });
}

void Flags::list(const std::string& flag, const char* what, const char* doc, std::vector<std::string>& values)
{
    app_.add_option(flag, values, doc)->type_name(what)->allow_extra_args(false);
}

void Flags::toggle(const std::string& flag, const char* doc, bool& value) { app_.add_flag(flag, value, doc); }

void Flags::count(const std::string& flag, const char* doc, int& value, int lower, int upper)
{
    this->value(flag, "N", doc, [=, &value](const std::string& text, const std::string& name) {
        value = parseCount(text, name, lower, upper);
    });
}

void Flags::count(const std::string& flag, const char* doc, std::optional<int>& value, int lower, int upper)
{
    this->value(flag, "N", doc, [=, &value](const std::string& text, const std::string& name) {
        value = parseCount(text, name, lower, upper);
    });
}

void Flags::number(const std::string& flag, const char* what, const char* doc, double& value, double lower,
                   double upper)
{
    this->value(flag, what, doc, [=, &value](const std::string& text, const std::string& name) {
        value = parseNumber(text, name, lower, upper);
    });
}

void Flags::number(const std::string& flag, const char* what, const char* doc, std::optional<double>& value,
                   double lower, double upper)
{
    this->value(flag, what, doc, [=, &value](const std::string& text, const std::string& name) {
        value = parseNumber(text, name, lower, upper);
    });
}

void Flags::vector(const std::string& flag, const char* doc, std::optional<vec3>& value)
{
    this->value(flag, "X,Y,Z", doc,
                [&value](const std::string& text, const std::string& name) { value = parseVec3(text, name); });
}

void Flags::size(const char* doc, ivec2& value)
{
    this->value("--size", "WxH", doc,
                [&value](const std::string& text, const std::string& name) { value = parseSize(text, name); });
}

void Flags::json(std::string& file)
{
    text("--json", "FILE", "Write the result as JSON to this file; - is standard output", file);
}

void Flags::convert() const
{
    for (const auto& step : pending_) step();
}

void addSceneFlags(Flags& flags, SceneArguments& scene)
{
    flags.path("SCENE", "FILE", "Scene file (.toml) or model (.obj); the shipped lake by default", scene.file);
    flags.list("--set", "KEY=VALUE", "Set an option, such as refraction.steps=3 (see: tarn options)",
               scene.settings.assignments);
    flags.text("--preset", "NAME",
               "Options that come with Tarn: fast, low, medium, high, best, thesis; auto takes those for the machine",
               scene.settings.preset);
    auto files = std::make_shared<std::vector<std::string>>();
    flags.list("--options", "FILE", "TOML file of options; it wins over --preset, --set over it", *files);
    flags.finally([files, &scene] { scene.settings.files.assign(files->begin(), files->end()); });
    flags.value("--water-level", "M", "Height of the water, m; gives a bare .obj its lake",
                [&scene](const std::string& text, const std::string& flag) {
                    scene.waterLevel = static_cast<float>(parseNumber(text, flag, -1e5, 1e5));
                });
    flags.text("--device", "NAME",
               "What to draw on without a window: part of a name that tarn info lists under devices", scene.device);
}

void addViewFlags(Flags& flags, ViewArguments& view)
{
    constexpr float radiansPerDegree = pi / 180.0f;
    flags.text("--camera", "NAME", "A camera of the scene; its first by default", view.camera.name);
    flags.vector("--eye", "Where the eye is, m; replaces the camera's", view.camera.eye);
    flags.vector("--target", "The point it looks at, m", view.camera.target);
    flags.vector("--up", "The direction that is up in the picture", view.camera.up);
    flags.value(
        "--fov", "DEG", "Vertical field of view, degrees", [&view](const std::string& text, const std::string& flag) {
            view.camera.verticalFov = static_cast<float>(parseNumber(text, flag, 1.0, 170.0)) * radiansPerDegree;
        });
    flags.value("--size", "WxH", "Size of the picture, pixels",
                [&view](const std::string& text, const std::string& flag) {
                    view.size = parseSize(text, flag);
                    view.sizeGiven = true;
                });
    flags.value("--time", "S", "Time of the waves at the start, s",
                [&view](const std::string& text, const std::string& flag) {
                    view.time = parseNumber(text, flag, -1e6, 1e6);
                    view.timeGiven = true;
                });
}

} // namespace tarn

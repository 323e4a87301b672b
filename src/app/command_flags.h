// The flags of one subcommand, as the file of that subcommand declares them (defineRender in render_command.cpp):
//
//     MakeCommand defineInfo(Flags& flags)
//     {
//         auto command = std::make_shared<InfoCommand>();
//         addSceneFlags(flags, command->scene);
//         flags.json(command->json);
//         return [command] { return *command; };
//     }
//
// CLI11 stays behind it: a subcommand's file is compiled without that library.
#pragma once

#include "app/command_line.h"

#include <functional>
#include <memory>

namespace CLI {
class App;
}

namespace tarn {

/// One command's flags. Text is turned into values by `convert` functions after CLI11 has told flags from
/// arguments, so that every message has the same form. What the flags assign to must outlive this object.
class Flags {
public:
    explicit Flags(CLI::App& app) : app_(app) {}

    using Convert = std::function<void(const std::string& text, const std::string& flag)>;

    /// @param what the value is, for --help: "FILE", "N"
    void value(const std::string& flag, const char* what, const char* doc, Convert convert);
    void text(const std::string& flag, const char* what, const char* doc, std::string& value);
    void path(const std::string& flag, const char* what, const char* doc, std::filesystem::path& value);
    /// A flag whose value may be left out.
    void optionalText(const std::string& flag, const char* what, const char* doc, std::string& value,
                      const char* whenLeftOut);
    /// A flag that may be repeated, one value each.
    void list(const std::string& flag, const char* what, const char* doc, std::vector<std::string>& values);
    void toggle(const std::string& flag, const char* doc, bool& value);
    void count(const std::string& flag, const char* doc, int& value, int lower, int upper);
    void count(const std::string& flag, const char* doc, std::optional<int>& value, int lower, int upper);
    void number(const std::string& flag, const char* what, const char* doc, double& value, double lower, double upper);
    void number(const std::string& flag, const char* what, const char* doc, std::optional<double>& value, double lower,
                double upper);
    void vector(const std::string& flag, const char* doc, std::optional<vec3>& value);
    /// --size WxH.
    void size(const char* doc, ivec2& value);
    /// --json, which most commands have.
    void json(std::string& file);

    /// One more thing to do once CLI11 is done.
    void finally(std::function<void()> step) { pending_.push_back(std::move(step)); }

    /// Calls what waits for CLI11 to be done, in the order of the declarations. Throws UsageError.
    void convert() const;

private:
    CLI::App& app_;
    std::vector<std::function<void()>> pending_;
};

/// SCENE, --set, --preset, --options, --water-level and --device.
void addSceneFlags(Flags& flags, SceneArguments& scene);

/// --camera or what makes one, --size and --time.
void addViewFlags(Flags& flags, ViewArguments& view);

} // namespace tarn

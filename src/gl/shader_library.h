// Compiles the shaders of a folder, and again when their files change.
//
//     ShaderLibrary shaders(projectRoot() / "shaders", {.blocks = {{"FrameBlock", 0}}});
//     auto water = shaders.program("water", "passes/water.vert", "passes/water.frag", {{"STEPS", "3"}});
//     …
//     shaders.pollChanges();   // once per frame
//
// A shader that does not compile at first is an Error. One that breaks while the program runs is logged as
// "shaders/passes/water.frag:12: message", and its last good program stays in use.
#pragma once

#include "gl/program.h"
#include "gl/shader_source.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tarn::gl {

class ShaderLibrary {
public:
    /// @param root the folder that includes and shader paths are relative to; must hold
    /// shared/glsl_prelude.glsl
    explicit ShaderLibrary(std::filesystem::path root, Bindings bindings = {});

    /// Asked again with the same four, it gives the same program while somebody holds it. Files are relative
    /// to the root. Throws Error with file, line and message.
    std::shared_ptr<Program> program(const std::string& name, const std::string& vertexFile,
                                     const std::string& fragmentFile, const Defines& defines = {});

    /// Looks at the files at most four times a second and rebuilds what is affected. Returns true when a
    /// program changed.
    bool pollChanges();
    /// The same, now.
    bool reloadChanged();

    /// What is wrong with the shaders on disk ("file:line: message"), or "" when all of them compile. For the
    /// HUD.
    const std::string& lastError() const { return lastError_; }

    /// Calls `next` before the first use of each program, until this is called with nothing; when it answers false, the
    /// use does not count as the first.
    void watchFirstUses(std::function<bool(const Program&)> next) { firstUses_->next = std::move(next); }

    /// How many programs were built so far, again for edited files too.
    std::size_t built() const { return built_; }
    /// How many of them because a file changed: what was drawn before may look otherwise now.
    std::size_t rebuilt() const { return rebuilt_; }

    const std::filesystem::path& root() const { return root_; }

private:
    struct Entry {
        std::weak_ptr<Program> program;
        std::string name, vertexFile, fragmentFile;
        Defines defines;
        std::vector<std::string> files; ///< that it is made of, sorted
        std::string error;              ///< of the latest attempt
    };

    /// Assembles, compiles and links; notes the files in the entry. Throws Error.
    Object build(Entry& entry) const;
    bool rebuild(Entry& entry);
    bool anyChanged();
    void watch(const Entry& entry);
    void collectErrors();

    std::shared_ptr<FirstUses> firstUses_ = std::make_shared<FirstUses>();
    std::filesystem::path root_;
    Bindings bindings_;
    std::vector<Entry> entries_;
    std::map<std::string, std::filesystem::file_time_type> times_; ///< of every watched file; min() when missing
    std::vector<std::string> changed_;
    std::size_t built_ = 0, rebuilt_ = 0;
    std::string lastError_;
    std::chrono::steady_clock::time_point lastPoll_{};
};

} // namespace tarn::gl

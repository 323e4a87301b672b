#include "gl/shader_library.h"

#include "base/error.h"
#include "base/log.h"
#include "gl/api.h"

#include <algorithm>
#include <utility>

namespace tarn::gl {

namespace {

constexpr std::chrono::milliseconds pollInterval{250};

/// A shader object; OpenGL keeps it as long as a program that it is attached to.
class Shader {
public:
    explicit Shader(GLenum stage) : name_(glCreateShader(stage)) {}
    ~Shader() { glDeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    Name name() const { return name_; }

private:
    Name name_;
};

template <typename GetParameter, typename GetLog>
std::string infoLog(Name name, GetParameter getParameter, GetLog getLog)
{
    GLint length = 0;
    getParameter(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    getLog(name, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

/// The first error, which is the cause of most others; warnings before it and the rest go to the debug log.
std::string firstComplaint(const std::string& log)
{
    if (log.find('\n') == std::string::npos) return log.empty() ? "the driver gives no reason" : log;
    log::debug("{}", log);
    const auto others = std::count(log.begin(), log.end(), '\n');
    const std::size_t error = log.find("error");
    const std::size_t before = error == std::string::npos ? error : log.rfind('\n', error);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    return fmt::format("{} (and {} more line{})", log.substr(begin, log.find('\n', begin) - begin), others,
                       others == 1 ? "" : "s");
}

void compile(const Shader& shader, const std::filesystem::path& root, const ShaderSource& source)
{
    const GLchar* text = source.text.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return;
    const std::string log = infoLog(shader.name(), glGetShaderiv, glGetShaderInfoLog);
    throw Error("{}", firstComplaint(nameFilesInLog(log, root, source.files)));
}

} // namespace

ShaderLibrary::ShaderLibrary(std::filesystem::path root, Bindings bindings)
    : root_(std::move(root)), bindings_(std::move(bindings))
{}

std::shared_ptr<Program> ShaderLibrary::program(const std::string& name, const std::string& vertexFile,
                                                const std::string& fragmentFile, const Defines& defines)
{
    for (const Entry& entry : entries_) {
        const bool isSame = entry.name == name && entry.vertexFile == vertexFile &&
                            entry.fragmentFile == fragmentFile && entry.defines == defines;
        if (!isSame) continue;
        if (auto existing = entry.program.lock()) return existing;
    }
    Entry entry{{}, name, vertexFile, fragmentFile, defines, {}, {}};
    const std::shared_ptr<Program> result(new Program(name, firstUses_));
    result->adopt(build(entry), bindings_);
    ++built_;
    entry.program = result;
    watch(entry);
    entries_.push_back(std::move(entry));
    return result;
}

Object ShaderLibrary::build(Entry& entry) const
{
    entry.files.clear();
    const ShaderSource vertexSource = assembleShader(root_, entry.vertexFile, entry.defines, &entry.files);
    const ShaderSource fragmentSource = assembleShader(root_, entry.fragmentFile, entry.defines, &entry.files);
    const Shader vertex(GL_VERTEX_SHADER);
    const Shader fragment(GL_FRAGMENT_SHADER);
    compile(vertex, root_, vertexSource);
    compile(fragment, root_, fragmentSource);

    Object linked(Object::Kind::program, entry.name);
    linked.announceLabel();
    glAttachShader(linked.name(), vertex.name());
    glAttachShader(linked.name(), fragment.name());
    glLinkProgram(linked.name());
    glDetachShader(linked.name(), vertex.name());
    glDetachShader(linked.name(), fragment.name());
    GLint status = GL_FALSE;
    glGetProgramiv(linked.name(), GL_LINK_STATUS, &status);
    if (status != GL_TRUE) {
        const std::string log = infoLog(linked.name(), glGetProgramiv, glGetProgramInfoLog);
        throw Error("program \"{}\" ({} with {}) does not link: {}", entry.name, entry.vertexFile, entry.fragmentFile,
                    firstComplaint(nameFilesInLog(log, root_, {})));
    }
    return linked;
}

bool ShaderLibrary::rebuild(Entry& entry)
{
    const std::shared_ptr<Program> program = entry.program.lock();
    std::vector<std::string> previousFiles = entry.files;
    try {
        program->adopt(build(entry), bindings_);
        ++built_;
        ++rebuilt_;
        if (!entry.error.empty()) log::info("program \"{}\" compiles again", entry.name);
        entry.error.clear();
        return true;
    } catch (const Error& error) {
        // What was not reached this time may hold the mistake: go on watching it.
        entry.files.insert(entry.files.end(), previousFiles.begin(), previousFiles.end());
        entry.error = error.what();
        return false;
    }
}

void ShaderLibrary::watch(const Entry& entry)
{
    for (const std::string& file : entry.files) {
        if (times_.contains(file)) continue;
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(root_ / file, missing);
        times_[file] = missing ? std::filesystem::file_time_type::min() : time;
    }
}

bool ShaderLibrary::anyChanged()
{
    changed_.clear();
    for (auto& [file, known] : times_) {
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(root_ / file, missing);
        // Editors that save by renaming leave a moment without the file: wait for it.
        if (missing || time == known) continue;
        known = time;
        changed_.push_back(file);
    }
    return !changed_.empty();
}

bool ShaderLibrary::pollChanges()
{
    const auto now = std::chrono::steady_clock::now();
    if (now - lastPoll_ < pollInterval) return false;
    lastPoll_ = now;
    return reloadChanged();
}

bool ShaderLibrary::reloadChanged()
{
    std::erase_if(entries_, [](const Entry& entry) { return entry.program.expired(); });
    if (!anyChanged()) return false;
    bool anyRebuilt = false;
    for (Entry& entry : entries_) {
        const bool isAffected = std::any_of(entry.files.begin(), entry.files.end(), [&](const std::string& file) {
            return std::find(changed_.begin(), changed_.end(), file) != changed_.end();
        });
        if (!isAffected) continue;
        anyRebuilt |= rebuild(entry);
        watch(entry);
    }
    collectErrors();
    return anyRebuilt;
}

void ShaderLibrary::collectErrors()
{
    // One broken file breaks many programs in the same way: say each thing once.
    std::vector<std::string> errors;
    for (const Entry& entry : entries_) {
        const bool isNew = std::find(errors.begin(), errors.end(), entry.error) == errors.end();
        if (!entry.error.empty() && isNew) errors.push_back(entry.error);
    }
    std::string all;
    for (const std::string& error : errors) {
        if (!all.empty()) all += '\n';
        all += error;
        if (lastError_.find(error) == std::string::npos) log::error("{}", error);
    }
    lastError_ = std::move(all);
}

} // namespace tarn::gl

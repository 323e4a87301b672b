#include "gl/shader_source.h"

#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

namespace tarn::gl {

namespace {

const char* const preludeFile = "shared/glsl_prelude.glsl";

/// Line n of file f is announced as line f * linesPerFile + n: Mesa gives source number 0 in all messages but
/// those of its lexer and preprocessor (22.3), so the file's number has to travel in the line's.
constexpr std::size_t linesPerFile = 100000;

std::string lineDirective(std::size_t line, std::size_t file)
{
    return fmt::format("#line {} {}\n", file * linesPerFile + line, file);
}

/// "shaders/passes/water.frag", as a person knows the file.
std::string displayName(const std::filesystem::path& root, const std::string& file)
{
    const std::filesystem::path folder = root.filename().empty() ? root.parent_path().filename() : root.filename();
    return (folder / file).generic_string();
}

/// Follows block comments from line to line, so that an #include within one stays a comment.
class CommentTracker {
public:
    /// Reads a line; returns whether its first character was inside a comment.
    bool next(std::string_view line)
    {
        const bool began = inside_;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const std::string_view two = line.substr(i, 2);
            if (!inside_ && two == "//") break;
            if (two != (inside_ ? "*/" : "/*")) continue;
            inside_ = !inside_;
            ++i;
        }
        return began;
    }

private:
    bool inside_ = false;
};

std::string_view trimmedFront(std::string_view line)
{
    const std::size_t start = line.find_first_not_of(" \t");
    return start == std::string_view::npos ? std::string_view() : line.substr(start);
}

/// What follows `#word` when the line is that directive.
std::optional<std::string_view> directive(std::string_view line, std::string_view word)
{
    line = trimmedFront(line);
    if (!line.starts_with('#')) return std::nullopt;
    line = trimmedFront(line.substr(1));
    if (!line.starts_with(word)) return std::nullopt;
    const std::string_view rest = line.substr(word.size());
    const bool isWholeWord = rest.empty() || rest[0] == ' ' || rest[0] == '\t' || rest[0] == '"' || rest[0] == '<';
    return isWholeWord ? std::optional(trimmedFront(rest)) : std::nullopt;
}

class Assembler {
public:
    Assembler(const std::filesystem::path& root, ShaderSource& source, std::vector<std::string>* visited)
        : root_(root), source_(source), visited_(visited)
    {}

    void append(const std::string& file, const std::string& askedBy)
    {
        if (visited_) visited_->push_back(file);
        if (!std::filesystem::is_regular_file(root_ / file)) {
            throw Error("{}no shader file \"{}\" in {}", askedBy.empty() ? "" : askedBy + ": ", file,
                        root_.generic_string());
        }
        const std::string text = readFile(root_ / file);
        const std::size_t id = source_.files.size();
        source_.files.push_back(file);
        appendLines(text, file, id);
    }

private:
    void appendLines(std::string_view text, const std::string& file, std::size_t id)
    {
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
        source_.text += lineDirective(1, id);
        CommentTracker comments;
        for (std::size_t number = 1; !text.empty(); ++number) {
            const std::size_t end = text.find('\n');
            std::string_view line = text.substr(0, end);
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
            if (line.ends_with('\r')) line.remove_suffix(1);

            const bool isComment = comments.next(line);
            const std::string place = displayName(root_, file) + ":" + std::to_string(number);
            if (!isComment && directive(line, "version")) {
                throw Error("{}: remove #version: the program puts \"#version 330 core\" in front", place);
            }
            const auto include = isComment ? std::nullopt : directive(line, "include");
            if (include && appendInclude(*include, place)) {
                source_.text += lineDirective(number + 1, id);
            } else {
                source_.text += include ? std::string_view() : line;
                source_.text += '\n';
            }
        }
    }

    /// Returns false when the file is in already.
    bool appendInclude(std::string_view argument, const std::string& place)
    {
        const std::size_t close = argument.find('"', 1);
        if (!argument.starts_with('"') || close == std::string_view::npos || close == 1) {
            throw Error("{}: #include wants a file in quotes: #include \"shared/waves.glsl\"", place);
        }
        const std::filesystem::path path(argument.substr(1, close - 1));
        const std::string file = path.lexically_normal().generic_string();
        const bool isKnown = std::find(source_.files.begin(), source_.files.end(), file) != source_.files.end();
        if (isKnown) return false;
        append(file, place);
        return true;
    }

    const std::filesystem::path& root_;
    ShaderSource& source_;
    std::vector<std::string>* visited_;
};

bool takePrefix(std::string_view& text, std::string_view prefix)
{
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
}

std::optional<std::size_t> takeNumber(std::string_view& text)
{
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

/// Takes the place off the front of a message and returns its line number, in the forms "0:12(5):" (Mesa),
/// "0(12) :" (NVIDIA) and "ERROR: 0:12:" (AMD, Apple, ANGLE).
std::optional<std::size_t> takePlace(std::string_view& text)
{
    if (!takePrefix(text, "ERROR: ")) takePrefix(text, "WARNING: ");
    if (!takeNumber(text)) return std::nullopt; // the source number: see linesPerFile
    const bool isNvidia = takePrefix(text, "(");
    if (!isNvidia && !takePrefix(text, ":")) return std::nullopt;
    const std::optional<std::size_t> line = takeNumber(text);
    if (!line || (isNvidia && !takePrefix(text, ")"))) return std::nullopt;
    if (!isNvidia && takePrefix(text, "(") && !(takeNumber(text) && takePrefix(text, ")"))) return std::nullopt;
    text = trimmedFront(text);
    if (!takePrefix(text, ":")) return std::nullopt;
    text = trimmedFront(text);
    return line;
}

std::string nameFileInLine(const std::string& line, const std::filesystem::path& root,
                           const std::vector<std::string>& files)
{
    std::string_view message = line;
    const std::optional<std::size_t> number = takePlace(message);
    if (!number || *number / linesPerFile >= files.size()) return line;
    takePrefix(message, "error: ");
    return fmt::format("{}:{}: {}", displayName(root, files[*number / linesPerFile]), *number % linesPerFile, message);
}

} // namespace

ShaderSource assembleShader(const std::filesystem::path& root, const std::string& file, const Defines& defines,
                            std::vector<std::string>* visited)
{
    ShaderSource source;
    source.text = "#version 330 core\n";
    for (const auto& [name, value] : defines) source.text += "#define " + name + " " + value + "\n";
    Assembler assembler(root, source, visited);
    assembler.append(preludeFile, "");
    assembler.append(file, "");
    return source;
}

std::string nameFilesInLog(std::string_view log, const std::filesystem::path& root,
                           const std::vector<std::string>& files)
{
    std::string result;
    while (!log.empty()) {
        const std::size_t end = log.find_first_of("\n\0", 0, 2);
        const std::string line(log.substr(0, end));
        log.remove_prefix(end == std::string_view::npos ? log.size() : end + 1);
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        if (!result.empty()) result += '\n';
        result += nameFileInLine(line, root, files);
    }
    return result;
}

} // namespace tarn::gl

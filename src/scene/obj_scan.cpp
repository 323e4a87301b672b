#include "scene/obj_scan.h"

#include "base/error.h"
#include "scene/text_scan.h"
#include "scene/warnings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

namespace tarn {

namespace {

struct LineSpan {
    std::size_t begin, end, number;
};

class Scanner {
public:
    Scanner(std::string text, const std::filesystem::path& file) : file_(file.string()), warnings_(file_)
    {
        result_.text = std::move(text);
        normaliseLines(result_.text);
    }

    ObjScan run()
    {
        const std::size_t zero = result_.text.find('\0');
        if (zero != std::string::npos)
            throw Error("{}: binary data at byte {}; this is not a Wavefront OBJ file", file_, zero);
        for (std::size_t begin = 0, number = 1; begin < result_.text.size();) {
            LineSpan line{begin, lineEnd(begin), number};
            const std::size_t joined = joinContinued(line);
            scanLine(line);
            begin = line.end + 1;
            number += 1 + joined;
        }
        for (const auto& face : forward_) checkFace(face.line, face.counts, true);
        if (result_.faces == 0 || result_.vertices == 0)
            throw Error("{}: nothing to draw, no usable face; is this a Wavefront OBJ file?", file_);
        return std::move(result_);
    }

private:
    struct Counts {
        std::size_t vertices, uvs, normals;
    };
    struct ForwardFace {
        LineSpan line;
        Counts counts;
    };

    std::size_t lineEnd(std::size_t begin) const
    {
        const auto end = result_.text.find('\n', begin);
        return end == std::string::npos ? result_.text.size() : end;
    }

    /// A backslash at a line's end continues it; blanked out, the two are one. Returns how many were joined.
    std::size_t joinContinued(LineSpan& line)
    {
        std::size_t joined = 0;
        auto& text = result_.text;
        for (;;) {
            std::size_t last = line.end;
            while (last > line.begin && isBlank(text[last - 1])) --last;
            if (last == line.begin || text[last - 1] != '\\' || line.end >= text.size()) return joined;
            text[last - 1] = ' ';
            text[line.end] = ' ';
            line.end = lineEnd(line.end + 1);
            ++joined;
        }
    }

    void scanLine(const LineSpan& line)
    {
        std::string_view rest(result_.text.data() + line.begin, line.end - line.begin);
        const std::string_view word = nextWord(rest);
        if (word.empty() || word[0] == '#') return;
        if (rest.empty() && word[0] == 'v') {
            // tinyobjloader does not count such a record, so neither may we.
            warn(line, fmt::format("'{}' without numbers is left out", printable(word)));
            drop(line);
        } else if (word == "v") {
            vertex(line, rest);
        } else if (word == "vt") {
            ++result_.uvs;
            numbers(line, rest, 1, "texture coordinate");
        } else if (word == "vn") {
            ++result_.normals;
            numbers(line, rest, 3, "normal");
        } else if (word == "f") {
            cutComment(line);
            checkFace(line, {result_.vertices, result_.uvs, result_.normals}, false);
        } else if (word == "s") {
            smoothing(rest);
            drop(line);
        } else if (word == "usemtl") {
            result_.materialLines.emplace(trimBlanks(rest), line.number);
        } else if (word == "mtllib") {
            result_.libraries.push_back({std::string(trimBlanks(rest)), line.number});
            drop(line);
        } else {
            if (!isHarmless(word)) warn(line, fmt::format("'{}' is not understood and left out", printable(word)));
            drop(line);
        }
    }

    /// Records of the format that have nothing to draw.
    static bool isHarmless(std::string_view word)
    {
        static constexpr std::array known{"g",        "o",        "l",          "p",        "vp",
                                          "mg",       "lod",      "maplib",     "usemap",   "bevel",
                                          "c_interp", "d_interp", "shadow_obj", "trace_obj"};
        return std::find(known.begin(), known.end(), word) != known.end();
    }

    static std::string printable(std::string_view word)
    {
        std::string result(word.substr(0, 20));
        std::replace_if(
            result.begin(), result.end(), [](char c) { return c < 32 || c > 126; }, '?');
        return result;
    }

    void warn(const LineSpan& line, std::string message)
    {
        if (line.end == result_.text.size()) message += " (the file ends in this line: is it cut short?)";
        warnings_.at(line.number, message);
    }

    void drop(const LineSpan& line)
    {
        std::size_t first = line.begin;
        while (isBlank(result_.text[first])) ++first;
        result_.text[first] = '#';
    }

    void cutComment(const LineSpan& line)
    {
        auto* begin = result_.text.data() + line.begin;
        auto* end = result_.text.data() + line.end;
        std::fill(std::find(begin, end, '#'), end, ' ');
    }

    /// Counts the numbers of a record; nothing when one of them is none.
    std::optional<int> numbers(const LineSpan& line, std::string_view rest, int needed, const char* what)
    {
        int count = 0;
        for (auto word = nextWord(rest); !word.empty() && word[0] != '#'; word = nextWord(rest), ++count) {
            if (isNumber(word)) continue;
            warn(line, fmt::format("{} is not a finite number: '{}'", what, printable(word)));
            return std::nullopt;
        }
        if (count >= needed) return count;
        warn(line, fmt::format("{} with {} numbers instead of {}", what, count, needed));
        return std::nullopt;
    }

    void vertex(const LineSpan& line, std::string_view rest)
    {
        const std::size_t index = result_.vertices++;
        const auto count = numbers(line, rest, 3, "coordinate");
        if (!count) {
            // The vertex stays, or all later indices would shift; the faces that use it go.
            bad_.resize(index + 1, false);
            bad_[index] = true;
        } else if (*count >= 6) {
            colour(index, rest, *count);
        }
    }

    void colour(std::size_t index, std::string_view rest, int count)
    {
        for (int i = 0; i < count - 3; ++i) nextWord(rest); // x y z, or x y z w
        std::uint32_t rgba = 0xff000000u;
        for (unsigned shift = 0; shift < 24; shift += 8) {
            float value = 1.0f;
            const auto word = nextWord(rest);
            std::from_chars(word.data(), word.data() + word.size(), value);
            rgba |= static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f)) << shift;
        }
        result_.colours.resize(index + 1, 0xffffffffu);
        result_.colours[index] = rgba;
    }

    void smoothing(std::string_view rest)
    {
        const auto word = nextWord(rest);
        std::uint32_t group = 0; // "off" and anything that is no number
        std::from_chars(word.data(), word.data() + word.size(), group);
        if (result_.smoothing.empty() || result_.smoothing.back().group != group)
            result_.smoothing.push_back({result_.faces, group});
    }

    enum class IndexCheck { good, later, bad };

    /// One index of "v/t/n" against the records so far.
    static IndexCheck checkIndex(long index, std::size_t count, bool atEnd)
    {
        if (index == 0) return IndexCheck::bad;
        if (index < 0) return static_cast<std::size_t>(-index) <= count ? IndexCheck::good : IndexCheck::bad;
        if (static_cast<std::size_t>(index) <= count) return IndexCheck::good;
        return atEnd ? IndexCheck::bad : IndexCheck::later;
    }

    struct CornerCheck {
        IndexCheck state = IndexCheck::good;
        std::string problem;
    };

    CornerCheck checkCorner(std::string_view corner, const Counts& counts, bool atEnd) const
    {
        const std::array<std::size_t, 3> limits = {counts.vertices, counts.uvs, counts.normals};
        static constexpr std::array names = {"vertex", "texture coordinate", "normal"};
        CornerCheck check;
        const char* at = corner.data();
        const char* const end = at + corner.size();
        for (std::size_t part = 0; part < 3; ++part) {
            if (part == 1 && at != end && *at == '/') { // v//n
                ++at;
                continue;
            }
            int index = 0;
            const auto [next, error] = std::from_chars(at, end, index);
            if (error == std::errc::invalid_argument)
                return {IndexCheck::bad, fmt::format("'{}' is not an index", printable(corner))};
            // A relative index counts from the face's own line, a positive one from the file's start.
            const std::size_t limit = index > 0 && atEnd ? totals()[part] : limits[part];
            const auto state = error == std::errc() ? checkIndex(index, limit, atEnd) : IndexCheck::bad;
            if (state == IndexCheck::bad)
                return {state, fmt::format("{} index {} is out of range (there are {})", names[part],
                                           std::string_view(at, static_cast<std::size_t>(next - at)), limit)};
            if (state == IndexCheck::later) check.state = state;
            if (part == 0 && isBadVertex(index, counts.vertices))
                return {IndexCheck::bad, "uses a vertex that was left out"};
            at = next;
            if (at == end) return check;
            if (*at != '/' || part == 2 || ++at == end)
                return {IndexCheck::bad, fmt::format("'{}' is not an index", printable(corner))};
        }
        return check;
    }

    std::array<std::size_t, 3> totals() const { return {result_.vertices, result_.uvs, result_.normals}; }

    bool isBadVertex(long index, std::size_t count) const
    {
        if (bad_.empty()) return false;
        const auto position = static_cast<std::size_t>(index > 0 ? index - 1 : static_cast<long>(count) + index);
        return position < bad_.size() && bad_[position];
    }

    /// `atEnd`: a face that pointed forward, seen again when all records are known.
    void checkFace(const LineSpan& line, const Counts& counts, bool atEnd)
    {
        std::string_view rest(result_.text.data() + line.begin, line.end - line.begin);
        nextWord(rest); // "f"
        int corners = 0;
        bool later = false;
        for (auto word = nextWord(rest); !word.empty(); word = nextWord(rest), ++corners) {
            const CornerCheck check = checkCorner(word, counts, atEnd);
            if (check.state == IndexCheck::bad) return rejectFace(line, check.problem, atEnd);
            later |= check.state == IndexCheck::later;
        }
        if (corners < 3) return rejectFace(line, fmt::format("{} corners instead of 3 or more", corners), atEnd);
        if (later) forward_.push_back({line, counts});
        if (!atEnd) ++result_.faces;
    }

    void rejectFace(const LineSpan& line, const std::string& problem, bool atEnd)
    {
        warn(line, "face left out: " + problem);
        if (!atEnd) return drop(line);
        // It was counted: its number stays, as a face without area, so that smoothing runs keep their places.
        auto* begin = result_.text.data() + line.begin;
        std::fill(begin, result_.text.data() + line.end, ' ');
        std::memcpy(begin, "f 1 1 1", std::min<std::size_t>(7, line.end - line.begin));
    }

    std::string file_;
    FileWarnings warnings_;
    ObjScan result_;
    std::vector<bool> bad_;
    std::vector<ForwardFace> forward_;
};

} // namespace

ObjScan scanObj(std::string text, const std::filesystem::path& file)
{
    if (text.empty()) throw Error("{}: the file is empty", file.string());
    return Scanner(std::move(text), file).run();
}

} // namespace tarn

#include "app/parse.h"

#include "base/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace tarn {

namespace {

constexpr int maxEdge = 16384;

/// The whole text as a number, in the C locale whatever the machine's is.
template <typename T> std::optional<T> number(std::string_view text)
{
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<float> finiteFloat(std::string_view text)
{
    const std::optional<float> value = number<float>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

} // namespace

ivec2 parseSize(std::string_view text, std::string_view flag)
{
    const std::size_t cross = text.find('x');
    if (cross != std::string_view::npos) {
        const auto width = number<int>(text.substr(0, cross));
        const auto height = number<int>(text.substr(cross + 1));
        if (width && height && *width >= 1 && *height >= 1 && *width <= maxEdge && *height <= maxEdge)
            return {*width, *height};
    }
    throw UsageError("{} {}: give WIDTHxHEIGHT in pixels, each from 1 to {}, such as 1024x768", flag, text, maxEdge);
}

vec3 parseVec3(std::string_view text, std::string_view flag)
{
    vec3 value{0.0f};
    std::string_view rest = text;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = rest.find(',');
        const bool last = i == 2;
        const auto component = finiteFloat(rest.substr(0, comma));
        if (!component || (comma == std::string_view::npos) != last)
            throw UsageError("{} {}: give three numbers x,y,z without spaces, such as 0,1.8,10", flag, text);
        value[i] = *component;
        rest.remove_prefix(last ? rest.size() : comma + 1);
    }
    return value;
}

double parseNumber(std::string_view text, std::string_view flag, double lower, double upper)
{
    const auto value = number<double>(text);
    if (!value || !(*value >= lower && *value <= upper))
        throw UsageError("{} {}: give a number from {} to {}", flag, text, lower, upper);
    return *value;
}

int parseCount(std::string_view text, std::string_view flag, int lower, int upper)
{
    const auto value = number<int>(text);
    if (!value || *value < lower || *value > upper)
        throw UsageError("{} {}: give a whole number from {} to {}", flag, text, lower, upper);
    return *value;
}

std::vector<std::string> parseNames(std::string_view text, std::string_view flag)
{
    std::vector<std::string> names;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        std::string name(rest.substr(0, comma));
        if (name.empty() || std::find(names.begin(), names.end(), name) != names.end())
            throw UsageError("{} {}: give names a,b,c, each once", flag, text);
        names.push_back(std::move(name));
        if (comma == std::string_view::npos) return names;
        rest.remove_prefix(comma + 1);
    }
}

std::vector<double> parseNumbers(std::string_view text, std::string_view flag)
{
    std::vector<double> values;
    for (const std::string& name : parseNames(text, flag)) {
        const auto value = number<double>(name);
        if (!value || !std::isfinite(*value))
            throw UsageError("{} {}: give numbers a,b,c without spaces, such as 0,1.7", flag, text);
        values.push_back(*value);
    }
    return values;
}

std::pair<int, int> parseShard(std::string_view text, std::string_view flag)
{
    constexpr int most = 10000;
    const std::size_t slash = text.find('/');
    if (slash != std::string_view::npos) {
        const auto part = number<int>(text.substr(0, slash));
        const auto parts = number<int>(text.substr(slash + 1));
        if (part && parts && *part >= 1 && *part <= *parts && *parts <= most) return {*part, *parts};
    }
    throw UsageError("{} {}: give PART/PARTS, such as 1/4 for the first of four", flag, text);
}

} // namespace tarn

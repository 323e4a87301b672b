#include "measure/trade/sweep.h"

#include "base/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace tarn {

namespace {

constexpr auto origin = "--sweep";
constexpr std::size_t mostValues = 1000; // more is a slip of the finger

std::vector<std::string> split(std::string_view text, char separator)
{
    std::vector<std::string> parts;
    for (;;) {
        const auto at = text.find(separator);
        parts.emplace_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

std::optional<double> number(std::string_view text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

struct Range {
    double first = 0.0, last = 0.0, step = 1.0;
    bool geometric = false;
};

/// "1:8", "0:1:0.25", "1:64:*2"; nothing when the text is no range of numbers.
std::optional<Range> parseRange(const std::string& text)
{
    const std::vector<std::string> parts = split(text, ':');
    if (parts.size() != 2 && parts.size() != 3) return {};
    Range range;
    std::string_view step = parts.size() == 3 ? std::string_view(parts[2]) : "1";
    range.geometric = step.starts_with('*');
    if (range.geometric) step.remove_prefix(1);
    const std::optional<double> numbers[] = {number(parts[0]), number(parts[1]), number(step)};
    for (const auto& value : numbers)
        if (!value) return {};
    range.first = *numbers[0];
    range.last = *numbers[1];
    range.step = *numbers[2];
    return range;
}

std::vector<std::string> valuesOf(const Range& range, std::string_view whole)
{
    const bool grows = range.geometric ? range.step > 1.0 && range.first > 0.0 : range.step > 0.0;
    if (!grows || range.last < range.first)
        throw UsageError("{} {}: a range goes up: FIRST:LAST, FIRST:LAST:STEP or FIRST:LAST:*FACTOR", origin, whole);
    std::vector<std::string> values;
    // Each is worked out from the first, so that rounding does not add up; the last may miss by as little.
    for (std::size_t i = 0;; ++i) {
        const double n = static_cast<double>(i);
        const double value = range.geometric ? range.first * std::pow(range.step, n) : range.first + n * range.step;
        if (value > range.last + 1e-9 * std::abs(range.last)) return values;
        if (values.size() == mostValues)
            throw UsageError("{} {}: more than {} values; take larger steps", origin, whole, mostValues);
        values.push_back(fmt::format("{:.9g}", value));
    }
}

std::vector<std::string> parseValues(const std::string& text, std::string_view whole)
{
    if (const std::optional<Range> range = parseRange(text)) return valuesOf(*range, whole);
    return split(text, text.find(';') == std::string::npos ? ',' : ';');
}

/// The value as the option itself would write it: "2.0" is "2".
std::string written(const std::string& key, const std::string& value, const DescribeSettings& describe)
{
    for (const FieldRow& row : describe({{key, value}}, origin))
        if (row.key == key) return row.value;
    throw UsageError("{}: there is no option '{}'; 'tarn options' lists them", origin, key);
}

} // namespace

Changes Sweep::changes(const std::string& value) const
{
    Changes all = with;
    all[key] = value;
    return all;
}

std::string Sweep::title() const
{
    std::string others;
    for (const auto& [other, value] : with) others += fmt::format("{}{}={}", others.empty() ? "" : ", ", other, value);
    return others.empty() ? key : fmt::format("{} ({})", key, others);
}

Sweep parseSweep(std::string_view text, const DescribeSettings& describe)
{
    std::vector<std::string> parts = split(text, '@');
    const Assignment assignment = parseAssignment(parts.front(), origin);
    Sweep sweep{assignment.key, {}};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const Assignment other = parseAssignment(parts[i], origin);
        if (other.key == sweep.key) throw UsageError("{} {}: sets {} beside its sweep", origin, text, other.key);
        sweep.with[other.key] = written(other.key, other.value, describe);
    }
    for (const std::string& value : parseValues(assignment.value, text)) {
        std::string canonical = written(sweep.key, value, describe);
        if (std::find(sweep.values.begin(), sweep.values.end(), canonical) == sweep.values.end())
            sweep.values.push_back(std::move(canonical));
    }
    return sweep;
}

std::vector<Sweep> parseSweeps(const std::vector<std::string>& texts, const DescribeSettings& describe)
{
    std::vector<Sweep> sweeps;
    for (const std::string& text : texts) {
        Sweep sweep = parseSweep(text, describe);
        for (const Sweep& other : sweeps)
            if (other.title() == sweep.title())
                throw UsageError("{} {}: {} is swept twice; give all its values at once", origin, text, sweep.title());
        sweeps.push_back(std::move(sweep));
    }
    return sweeps;
}

} // namespace tarn

// Setting a field from text, and saying what is wrong when that fails.
#include "base/error.h"
#include "base/fields_path.h"
#include "base/log.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace tarn {

namespace {

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

template <typename T> bool parseNumber(std::string_view text, T& value)
{
    text = trimmed(text);
    if (text.size() > 1 && text.front() == '+') text.remove_prefix(1); // from_chars knows no plus sign
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const auto at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

class AssignVisitor : public PathVisitor {
public:
    explicit AssignVisitor(const Assignment& assignment) : assignment_(assignment) {}

    bool found() const { return found_; }
    const std::vector<std::string>& keys() const { return keys_; }

    void field(const FieldInfo& info, bool& value) override
    {
        if (!wanted(info)) return;
        const auto text = trimmed(assignment_.value);
        if (text == "true" || text == "on" || text == "1") {
            value = true;
        } else if (text == "false" || text == "off" || text == "0") {
            value = false;
        } else {
            fail("must be true or false");
        }
    }

    void field(const FieldInfo& info, int& value) override
    {
        if (!wanted(info)) return;
        int parsed = 0;
        if (!parseNumber(assignment_.value, parsed)) fail("must be a whole number");
        checkRange(info, parsed);
        value = parsed;
    }

    void field(const FieldInfo& info, float& value) override
    {
        if (!wanted(info)) return;
        value = component(info, assignment_.value, "must be a number");
    }

    void field(const FieldInfo& info, vec2& value) override
    {
        if (wanted(info)) vectorField<2>(info, value, "must be two numbers 'x,y', or one for both");
    }

    void field(const FieldInfo& info, vec3& value) override
    {
        if (wanted(info)) vectorField<3>(info, value, "must be three numbers 'x,y,z', or one for all");
    }

    void choiceIndex(const FieldInfo& info, int& value, std::span<const char* const> names) override
    {
        if (!wanted(info)) return;
        const auto text = trimmed(assignment_.value);
        const auto match = std::find(names.begin(), names.end(), text);
        if (match == names.end()) fail("must be one of " + joinNames(names, ", "));
        value = static_cast<int>(match - names.begin());
    }

private:
    bool wanted(const FieldInfo& info)
    {
        keys_.push_back(keyOf(info));
        if (keys_.back() != assignment_.key) return false;
        found_ = true;
        return true;
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw UsageError("{}: {} {}, not '{}'", assignment_.origin, assignment_.key, what, assignment_.value);
    }

    void checkRange(const FieldInfo& info, double value) const
    {
        if (!std::isfinite(value)) fail("must be finite");
        if (value < info.lower || value > info.upper) fail("must be " + rangeText(info));
    }

    float component(const FieldInfo& info, std::string_view text, const char* expected) const
    {
        double parsed = 0.0;
        if (!parseNumber(text, parsed)) fail(expected);
        checkRange(info, parsed);
        const auto value = static_cast<float>(parsed);
        if (!std::isfinite(value)) fail("must be finite");
        return value;
    }

    template <int N, typename Vector> void vectorField(const FieldInfo& info, Vector& value, const char* expected) const
    {
        const auto parts = split(assignment_.value, ',');
        if (parts.size() != 1 && parts.size() != N) fail(expected);
        Vector parsed;
        for (int i = 0; i < N; ++i)
            parsed[i] = component(info, parts[parts.size() == 1 ? 0 : static_cast<std::size_t>(i)], expected);
        value = parsed;
    }

    const Assignment& assignment_;
    std::vector<std::string> keys_;
    bool found_ = false;
};

/// Finds the present name of a field that is given by an old one.
class RenameVisitor : public PathVisitor {
public:
    explicit RenameVisitor(std::string_view key) : key_(key) {}

    const std::string& present() const { return present_; } ///< empty where the key is no old name

    void field(const FieldInfo&, bool&) override {}
    void field(const FieldInfo&, int&) override {}
    void field(const FieldInfo&, float&) override {}
    void field(const FieldInfo&, vec2&) override {}
    void field(const FieldInfo&, vec3&) override {}
    void choiceIndex(const FieldInfo&, int&, std::span<const char* const>) override {}
    void renamed(const char* oldName, const char* name) override
    {
        if (keyOf(FieldInfo{oldName, ""}) == key_) present_ = keyOf(FieldInfo{name, ""});
    }

private:
    std::string_view key_;
    std::string present_;
};

/// Levenshtein distance.
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

} // namespace

std::string nearestName(std::string_view word, std::span<const std::string> candidates)
{
    std::string best;
    // Farther than half the word is no longer a slip of the finger.
    std::size_t bestDistance = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (const auto& candidate : candidates) {
        std::size_t distance = editDistance(word, candidate);
        // "steps" for "refraction.steps": the group was forgotten.
        const auto dot = candidate.rfind('.');
        if (dot != std::string::npos) distance = std::min(distance, editDistance(word, candidate.substr(dot + 1)) + 1);
        if (distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

void assign(const FieldTree& tree, const Assignment& assignment)
{
    AssignVisitor visitor(assignment);
    tree(visitor);
    if (visitor.found()) return;
    RenameVisitor renames(assignment.key);
    tree(renames);
    if (const std::string& present = renames.present(); !present.empty()) {
        log::warning("{}: {} is now called {}", assignment.origin, assignment.key, present);
        assign(tree, {present, assignment.value, assignment.origin});
        return;
    }
    const auto nearest = nearestName(assignment.key, visitor.keys());
    throw UsageError("{}: there is no option '{}'; {}", assignment.origin, assignment.key,
                     nearest.empty() ? "'tarn options' lists them" : "did you mean '" + nearest + "'?");
}

Assignment parseAssignment(std::string_view text, std::string_view origin)
{
    const auto equals = text.find('=');
    const auto key = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || key.empty())
        throw UsageError("{}: '{}' is not of the form key=value", origin, text);
    return {std::string(key), std::string(trimmed(text.substr(equals + 1))), std::string(origin)};
}

} // namespace tarn

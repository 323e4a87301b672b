// Option files.
#include "app/options_table.h"
#include "app/settings.h"
#include "base/error.h"
#include "base/files.h"

namespace tarn {

namespace {

/// A number, a truth value, a name or a row of numbers, as --set would take it; empty for anything else.
std::string valueText(const toml::node& node)
{
    if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
    if (const auto* value = node.as_integer()) return fmt::format("{}", value->get());
    if (const auto* value = node.as_floating_point()) return fmt::format("{}", value->get());
    if (const auto* value = node.as_string()) return value->get();
    std::string text;
    if (const toml::array* values = node.as_array()) {
        for (const toml::node& value : *values) {
            if (!value.is_number()) return "";
            if (!text.empty()) text += ',';
            text += valueText(value);
        }
    }
    return text;
}

void flatten(const toml::table& table, const std::string& prefix, const std::string& file,
             std::vector<Assignment>& result)
{
    for (const auto& [name, node] : table) {
        const std::string key = prefix + std::string(name.str());
        if (const toml::table* group = node.as_table()) {
            flatten(*group, key + ".", file, result);
            continue;
        }
        std::string origin = fmt::format("{}:{}", file, node.source().begin.line);
        std::string value = valueText(node);
        if (value.empty() && !node.is_string())
            throw UsageError("{}: {} wants a number, true, false, a name or [numbers]", origin, key);
        result.push_back({key, std::move(value), std::move(origin)});
    }
}

} // namespace

std::vector<Assignment> assignmentsOf(const toml::table& table, const std::string& file)
{
    std::vector<Assignment> result;
    flatten(table, "", file, result);
    return result;
}

std::vector<Assignment> readOptionsFile(const std::filesystem::path& file)
{
    const std::string text = readFile(file);
    toml::table table;
    try {
        table = toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        throw UsageError("{}:{}: {}", file.string(), error.source().begin.line, error.description());
    }
    return assignmentsOf(table, file.string());
}

} // namespace tarn

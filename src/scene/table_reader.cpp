#include "scene/table_reader.h"

#include "base/error.h"
#include "base/fields.h"

#include <algorithm>
#include <cmath>

namespace tarn {

std::string typeName(const toml::node& node)
{
    switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "an array";
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "an integer";
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "true or false";
    default: return "a date or time";
    }
}

namespace {

std::string rangeText(const KeyRange& range)
{
    const std::string unit = *range.unit ? std::string(" ") + range.unit : "";
    if (range.lowerExcluded) return fmt::format("more than {} and at most {}{}", range.lower, range.upper, unit);
    if (std::isfinite(range.upper)) return fmt::format("{} to {}{}", range.lower, range.upper, unit);
    return fmt::format("at least {}{}", range.lower, unit);
}

} // namespace

TableReader::TableReader(const toml::table& table, std::string file, std::string section)
    : table_(table), file_(std::move(file)), section_(std::move(section))
{}

std::string TableReader::place() const
{
    return fmt::format("{}:{}", file_, std::max<toml::source_index>(table_.source().begin.line, 1));
}

std::string TableReader::place(const char* key) const
{
    const toml::node* node = table_.get(key);
    return node ? fmt::format("{}:{}", file_, node->source().begin.line) : place();
}

void TableReader::fail(const char* key, const std::string& problem) const
{
    throw Error("{}: {}{}{} {}", place(key), section_, section_.empty() ? "" : ".", key, problem);
}

const toml::node* TableReader::find(const char* key)
{
    known_.emplace_back(key);
    return table_.get(key);
}

const toml::table* TableReader::subtable(const char* key)
{
    const toml::node* node = find(key);
    if (!node) return nullptr;
    if (!node->is_table()) fail(key, fmt::format("must be a table [{}], not {}", key, typeName(*node)));
    return node->as_table();
}

std::vector<const toml::table*> TableReader::tables(const char* key)
{
    std::vector<const toml::table*> result;
    const toml::node* node = find(key);
    if (!node) return result;
    if (!node->is_array()) fail(key, fmt::format("must be tables [[{}]], not {}", key, typeName(*node)));
    for (const toml::node& entry : *node->as_array()) {
        if (!entry.is_table()) fail(key, fmt::format("must be tables [[{}]], not {}", key, typeName(entry)));
        result.push_back(entry.as_table());
    }
    return result;
}

void TableReader::require(std::initializer_list<const char*> required)
{
    for (const char* key : required)
        if (!table_.contains(key)) fail(key, "is missing");
}

void TableReader::finish() const
{
    for (const auto& [key, node] : table_) {
        const std::string name(key.str());
        if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
        const std::string nearest = nearestName(name, known_);
        throw Error("{}:{}: there is no key '{}' {}{}{}", file_, node.source().begin.line, name,
                    section_.empty() ? "in a scene file" : "in " + section_,
                    nearest.empty() ? "; it knows " : "; did you mean '",
                    nearest.empty() ? fmt::format("{}", fmt::join(known_, ", ")) : nearest + "'?");
    }
}

double TableReader::readNumber(const char* key, const toml::node& node, const KeyRange& range) const
{
    if (!node.is_number()) fail(key, fmt::format("must be a number, not {}", typeName(node)));
    const double value = node.value<double>().value();
    if (!std::isfinite(value)) fail(key, "must be a finite number");
    if (value < range.lower || value > range.upper || (range.lowerExcluded && value == range.lower))
        fail(key, fmt::format("must be {}, not {}", rangeText(range), value));
    if (std::abs(value) > std::numeric_limits<float>::max()) fail(key, fmt::format("is too large: {}", value));
    return value;
}

void TableReader::number(const char* key, float& value, const KeyRange& range)
{
    if (const toml::node* node = find(key)) value = static_cast<float>(readNumber(key, *node, range));
}

void TableReader::integer(const char* key, int& value, const KeyRange& range)
{
    const toml::node* node = find(key);
    if (!node) return;
    if (!node->is_integer()) fail(key, fmt::format("must be a whole number, not {}", typeName(*node)));
    value = static_cast<int>(readNumber(key, *node, range));
}

void TableReader::angle(const char* key, float& radians, const KeyRange& degrees)
{
    if (const toml::node* node = find(key)) radians = static_cast<float>(glm::radians(readNumber(key, *node, degrees)));
}

template <int N, typename Vector>
void TableReader::readVector(const char* key, Vector& value, const KeyRange& range, bool scalarToo)
{
    const toml::node* node = find(key);
    if (!node) return;
    if (scalarToo && node->is_number()) {
        value = Vector(static_cast<float>(readNumber(key, *node, range)));
        return;
    }
    const toml::array* array = node->as_array();
    if (!array || array->size() != N)
        fail(key, fmt::format("must be {} numbers in brackets{}, not {}", N, scalarToo ? " or one number" : "",
                              array ? fmt::format("{}", array->size()) : typeName(*node)));
    for (int i = 0; i < N; ++i)
        value[i] = static_cast<float>(readNumber(key, *array->get(static_cast<std::size_t>(i)), range));
}

void TableReader::angles(const char* key, vec3& radians)
{
    vec3 degrees = glm::degrees(radians);
    readVector<3>(key, degrees, {-36000.0, 36000.0, "degrees"}, false);
    if (table_.contains(key)) radians = glm::radians(degrees);
}

void TableReader::vector(const char* key, vec2& value, const KeyRange& range)
{
    readVector<2>(key, value, range, false);
}
void TableReader::vector(const char* key, vec3& value, const KeyRange& range)
{
    readVector<3>(key, value, range, false);
}
void TableReader::uniform(const char* key, vec2& value, const KeyRange& range)
{
    readVector<2>(key, value, range, true);
}
void TableReader::uniform(const char* key, vec3& value, const KeyRange& range)
{
    readVector<3>(key, value, range, true);
}

void TableReader::flag(const char* key, bool& value)
{
    const toml::node* node = find(key);
    if (!node) return;
    if (!node->is_boolean()) fail(key, fmt::format("must be true or false, not {}", typeName(*node)));
    value = node->as_boolean()->get();
}

void TableReader::text(const char* key, std::string& value)
{
    const toml::node* node = find(key);
    if (!node) return;
    if (!node->is_string()) fail(key, fmt::format("must be a string in quotes, not {}", typeName(*node)));
    value = node->as_string()->get();
}

void TableReader::path(const char* key, std::filesystem::path& value)
{
    std::string written = value.string();
    text(key, written);
    value = written;
}

void TableReader::choiceIndex(const char* key, int& value, std::span<const char* const> names)
{
    std::string chosen = names[static_cast<std::size_t>(value)];
    text(key, chosen);
    const auto found = std::find(names.begin(), names.end(), chosen);
    if (found == names.end())
        fail(key, fmt::format("must be one of {}, not '{}'", fmt::join(names.begin(), names.end(), ", "), chosen));
    value = static_cast<int>(found - names.begin());
}

} // namespace tarn

// Options as a list for people and as JSON for programs.
#include "base/fields_path.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace tarn {

std::string rangeText(const FieldInfo& info)
{
    const std::string unit = *info.unit ? std::string(" ") + info.unit : "";
    const bool below = std::isfinite(info.lower), above = std::isfinite(info.upper);
    if (below && above) return fmt::format("{} to {}{}", info.lower, info.upper, unit);
    if (below) return fmt::format("at least {}{}", info.lower, unit);
    if (above) return fmt::format("at most {}{}", info.upper, unit);
    return "";
}

namespace {

class ListVisitor : public PathVisitor {
public:
    std::vector<FieldRow> rows;

    void field(const FieldInfo& info, bool& value) override { add(info, "bool", valueText(value)); }
    void field(const FieldInfo& info, int& value) override { add(info, "int", valueText(value)); }
    void field(const FieldInfo& info, float& value) override { add(info, "float", valueText(value)); }
    void field(const FieldInfo& info, vec2& value) override { add(info, "vec2", valueText(value)); }
    void field(const FieldInfo& info, vec3& value) override { add(info, "vec3", valueText(value)); }
    void choiceIndex(const FieldInfo& info, int& value, std::span<const char* const> names) override
    {
        add(info, "choice", names[static_cast<std::size_t>(value)]);
        rows.back().range = joinNames(names, " | ");
    }

private:
    void add(const FieldInfo& info, const char* type, std::string value)
    {
        FieldInfo unitless = info; // the unit has a column of its own
        unitless.unit = "";
        rows.push_back({keyOf(info), type, std::move(value), info.unit, rangeText(unitless), info.doc});
    }
};

/// A float as a person would write it: 0.1, not 0.10000000149011612.
double shortest(float value) { return std::strtod(valueText(value).c_str(), nullptr); }

class JsonVisitor : public FieldVisitor {
public:
    nlohmann::json root = nlohmann::json::object();

    void enter(const char* group, const char*) override
    {
        auto& child = (*open_.back())[group];
        if (child.is_null()) child = nlohmann::json::object();
        open_.push_back(&child);
    }
    void leave() override { open_.pop_back(); }

    void field(const FieldInfo& info, bool& value) override { at(info) = value; }
    void field(const FieldInfo& info, int& value) override { at(info) = value; }
    void field(const FieldInfo& info, float& value) override { at(info) = shortest(value); }
    void field(const FieldInfo& info, vec2& value) override { at(info) = {shortest(value.x), shortest(value.y)}; }
    void field(const FieldInfo& info, vec3& value) override
    {
        at(info) = {shortest(value.x), shortest(value.y), shortest(value.z)};
    }
    void choiceIndex(const FieldInfo& info, int& value, std::span<const char* const> names) override
    {
        at(info) = names[static_cast<std::size_t>(value)];
    }

private:
    nlohmann::json& at(const FieldInfo& info) { return (*open_.back())[info.name]; }

    // Objects are filled one at a time and node addresses in a json object (a std::map) stay put.
    std::vector<nlohmann::json*> open_{&root};
};

} // namespace

std::vector<FieldRow> listFields(const FieldTree& tree)
{
    ListVisitor visitor;
    tree(visitor);
    return std::move(visitor.rows);
}

nlohmann::json toJson(const FieldTree& tree)
{
    JsonVisitor visitor;
    tree(visitor);
    return std::move(visitor.root);
}

} // namespace tarn

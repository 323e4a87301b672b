// What the visitors of fields_assign.cpp and fields_list.cpp share: the name of the field they are at, and
// how values are written. Private to src/base.
#pragma once

#include "base/fields.h"

#include <fmt/format.h>

namespace tarn {

/// Keeps "group.subgroup." while a tree is visited.
class PathVisitor : public FieldVisitor {
public:
    void enter(const char* group, const char*) override
    {
        ends_.push_back(path_.size());
        path_.append(group).push_back('.');
    }
    void leave() override
    {
        path_.resize(ends_.back());
        ends_.pop_back();
    }

protected:
    std::string keyOf(const FieldInfo& info) const { return path_ + info.name; }

private:
    std::string path_;
    std::vector<std::size_t> ends_;
};

inline std::string valueText(bool value) { return value ? "true" : "false"; }
inline std::string valueText(int value) { return fmt::format("{}", value); }
inline std::string valueText(float value) { return fmt::format("{}", value); }
inline std::string valueText(const vec2& value) { return fmt::format("{},{}", value.x, value.y); }
inline std::string valueText(const vec3& value) { return fmt::format("{},{},{}", value.x, value.y, value.z); }

inline std::string joinNames(std::span<const char* const> names, const char* separator)
{
    return fmt::format("{}", fmt::join(names.begin(), names.end(), separator));
}

/// "1 to 64 m", "at least 0 m", or "" when everything is allowed.
std::string rangeText(const FieldInfo& info);

} // namespace tarn

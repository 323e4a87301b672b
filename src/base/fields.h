// Options as plain structs. A struct tells its fields once, in a function
//
//     void visit(FieldVisitor& v, RefractionOptions& o)
//     {
//         v.field({"steps", "Steps of the intersection search", "", 1, 64}, o.steps);
//         v.choice({"method", "How W is found"}, o.method, refractionMethodNames);
//     }
//
// and from that come the command line (--set refraction.steps=3), the scene file, the panel, the sweeps,
// `tarn options` and the JSON in every result. Adding an option is one line there.
#pragma once

#include "base/math.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tarn {

struct FieldInfo {
    const char* name;
    const char* doc;
    const char* unit = "";
    double lower = -std::numeric_limits<double>::infinity(); ///< inclusive; per component for vectors
    double upper = std::numeric_limits<double>::infinity();
};

class FieldVisitor {
public:
    virtual ~FieldVisitor() = default;

    /// Fields visited until leave() are named "group.field".
    virtual void enter(const char* group, const char* doc) = 0;
    virtual void leave() = 0;

    virtual void field(const FieldInfo& info, bool& value) = 0;
    virtual void field(const FieldInfo& info, int& value) = 0;
    virtual void field(const FieldInfo& info, float& value) = 0;
    virtual void field(const FieldInfo& info, vec2& value) = 0;
    virtual void field(const FieldInfo& info, vec3& value) = 0;
    /// A field of this group that had another name once: that still sets it, with a warning.
    virtual void renamed(const char* /*oldName*/, const char* /*name*/) {}
    /// One of a set of names; value is its index.
    virtual void choiceIndex(const FieldInfo& info, int& value, std::span<const char* const> names) = 0;

    /// An enumeration whose values are 0, 1, 2 … in the order of the names.
    template <typename E> void choice(const FieldInfo& info, E& value, std::span<const char* const> names)
    {
        int index = static_cast<int>(value);
        choiceIndex(info, index, names);
        value = static_cast<E>(index);
    }
};

/// A whole tree of options: a function that visits every struct in it.
using FieldTree = std::function<void(FieldVisitor&)>;

/// One `key = value` and where it stood, for error messages ("lake.toml:12", "--set").
struct Assignment {
    std::string key;   ///< "refraction.steps"
    std::string value; ///< "3", "true", "planar", "0.1,0.2,0.3"
    std::string origin;
};

/// Sets one field. Throws UsageError that names the origin, the key, what is wrong with the value (type, range,
/// choices) and, for an unknown key, the nearest one there is.
void assign(const FieldTree& tree, const Assignment& assignment);

/// "key=value" from the command line.
Assignment parseAssignment(std::string_view text, std::string_view origin);

/// A field as `tarn options` and the panel list it.
struct FieldRow {
    std::string key, type, value, unit, range, doc;
};
std::vector<FieldRow> listFields(const FieldTree& tree);

/// {"refraction": {"steps": 3, …}, …}
nlohmann::json toJson(const FieldTree& tree);

/// The candidate with the smallest edit distance to the word, or "" when none is near.
std::string nearestName(std::string_view word, std::span<const std::string> candidates);

} // namespace tarn

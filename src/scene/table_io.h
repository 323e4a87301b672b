// One table of a scene file, key by key, read or written by the same description (scene_keys.h). Private to
// src/scene.
#pragma once

#include "base/math.h"

#include <filesystem>
#include <limits>
#include <span>
#include <string>

namespace tarn {

struct KeyRange {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    const char* unit = "";
    bool lowerExcluded = false; ///< "more than 0"
};

class TableIo {
public:
    virtual ~TableIo() = default;

    virtual void number(const char* key, float& value, const KeyRange& range = {}) = 0;
    virtual void integer(const char* key, int& value, const KeyRange& range) = 0;
    /// Degrees in the file (and the range), radians in memory.
    virtual void angle(const char* key, float& radians, const KeyRange& degrees = {}) = 0;
    virtual void angles(const char* key, vec3& radians) = 0;
    /// Exactly as many numbers as components.
    virtual void vector(const char* key, vec2& value, const KeyRange& range = {}) = 0;
    virtual void vector(const char* key, vec3& value, const KeyRange& range = {}) = 0;
    /// The same, or one number for all components: colours, scales.
    virtual void uniform(const char* key, vec2& value, const KeyRange& range = {}) = 0;
    virtual void uniform(const char* key, vec3& value, const KeyRange& range = {}) = 0;
    virtual void flag(const char* key, bool& value) = 0;
    virtual void text(const char* key, std::string& value) = 0;
    virtual void path(const char* key, std::filesystem::path& value) = 0;
    virtual void choiceIndex(const char* key, int& value, std::span<const char* const> names) = 0;

    template <typename E> void choice(const char* key, E& value, std::span<const char* const> names)
    {
        int index = static_cast<int>(value);
        choiceIndex(key, index, names);
        value = static_cast<E>(index);
    }
};

} // namespace tarn

// A linked pair of shaders. Made and kept up to date by a ShaderLibrary.
//
//     program->use();
//     program->set("exposure", 1.5f);               // a hash of the name, no search by the driver
//     program->texture("sceneColour", target.colour());
//     Uniform<vec3> tint = program->uniform<vec3>("tint");  tint.set(v);   // not even the hash
//
// Values may be set before or after use(), stay set, and survive a reload of the shader. A uniform that the
// shader does not have is a debug message, once: the compiler drops those that an option switches off. One
// with another type than the shader's is an Error.
#pragma once

#include "base/math.h"
#include "gl/object.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tarn::gl {

class Program;
class Texture;

/// Which index a uniform block gets and which unit a sampler, by name. Every block must be listed; samplers
/// that are not get the units that are free in their program.
struct Bindings {
    std::vector<std::pair<std::string, int>> blocks;
    std::vector<std::pair<std::string, int>> samplers;
};

/// A place for a value of type bool, int, float, vec2, vec3, vec4, ivec2, ivec3, ivec4, mat3 or mat4. Lives
/// no longer than its program; stays good when that is reloaded.
template <typename T> class Uniform {
public:
    Uniform() = default;
    void set(const T& value) const;

private:
    friend class Program;
    Uniform(Program& program, int slot) : program_(&program), slot_(slot) {}
    Program* program_ = nullptr;
    int slot_ = -1;
};

class Program;

/// Watches for the first use of each program of a library: many drivers finish a program at its first draw.
struct FirstUses {
    std::function<bool(const Program&)> next; ///< called before it; when the answer is false, the use does not count
};

/// Called with every texture that a program of this thread is given, so that tests can hold what passes read against
/// what they declare. Empty: none.
void observeTextures(std::function<void(const Texture&)> observer);

class Program {
public:
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    const std::string& name() const { return name_; }
    void use() const;

    template <typename T> Uniform<T> uniform(std::string_view uniformName)
    {
        return Uniform<T>(*this, slot(uniformName));
    }
    template <typename T> void set(std::string_view uniformName, const T& value) { uniform<T>(uniformName).set(value); }
    /// The first values.size() elements of `uniform T name[n]`.
    template <typename T> void setArray(std::string_view uniformName, std::span<const T> values);

    /// Binds the texture to the sampler's unit.
    void texture(std::string_view samplerName, const Texture& texture);
    /// The sampler's unit, or nothing when the shader does not use it.
    std::optional<int> samplerUnit(std::string_view samplerName) const;

    /// How the driver lays a block out, for checks against C++: its size in bytes, and the offset of a member
    /// named as in GLSL ("lights[0].position" or "time"). Nothing when the program does not use it.
    std::optional<int> blockSize(std::string_view blockName) const;
    std::optional<int> blockOffset(std::string_view memberName) const;

    /// Goes up by one with every successful reload.
    int generation() const { return generation_; }

private:
    friend class ShaderLibrary;
    template <typename T> friend class Uniform;
    enum class Type { boolean, integer, scalar, vec2, vec3, vec4, ivec2, ivec3, ivec4, mat3, mat4 };
    struct Slot {
        std::string name;
        int location = -1;
        unsigned glType = 0;      ///< what the shader declares, 0: it does not have it
        int capacity = 0;         ///< elements the shader declares
        std::optional<Type> type; ///< of the value below; none until it is first set
        int count = 0;
        std::vector<std::byte> value;
        bool dirty = false;
    };
    struct Active {
        unsigned glType;
        int count; ///< elements; 1 unless it is an array
    };
    struct NameHash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
    };
    template <typename T> using NameMap = std::unordered_map<std::string, T, NameHash, std::equal_to<>>;
    using ActiveMap = NameMap<Active>;

    static ActiveMap activeUniforms(Name program);
    static void locate(Slot& slot, Name program, const ActiveMap& active);
    /// Throws Error when a value of this type and count cannot go there.
    void checkFits(const Slot& slot, Type type, int count) const;
    static NameMap<int> assignUnits(Name program, const ActiveMap& active, const Bindings& bindings,
                                    const std::string& programName);

    explicit Program(std::string name, std::shared_ptr<FirstUses> firstUses);
    /// Takes over a linked program; throws Error, and stays as it was, when a block has no binding or a value
    /// that was set no longer fits.
    void adopt(Object linked, const Bindings& bindings);
    template <typename T> static constexpr Type typeOf();
    int slot(std::string_view uniformName);
    void store(int slot, Type type, int count, const void* data, std::size_t bytes);
    void upload(Slot& slot) const;
    void noteMissing(std::string_view what, std::string_view missingName);

    std::string name_;
    Object object_;
    ActiveMap active_;       ///< what the linked program has, by name; arrays without their "[0]"
    NameMap<int> units_;     ///< of its samplers
    NameMap<int> slotIndex_; ///< into slots_
    NameMap<bool> missing_;  ///< names already complained about
    mutable std::vector<Slot> slots_;
    mutable bool anyDirty_ = false;
    int generation_ = 0;
    std::shared_ptr<FirstUses> firstUses_;
    mutable bool used_ = false;                  ///< since it was linked
    static thread_local const Program* current_; ///< of this thread's context
};

template <typename T> constexpr Program::Type Program::typeOf()
{
    if constexpr (std::is_same_v<T, bool>)
        return Type::boolean;
    else if constexpr (std::is_same_v<T, int>)
        return Type::integer;
    else if constexpr (std::is_same_v<T, float>)
        return Type::scalar;
    else if constexpr (std::is_same_v<T, tarn::vec2>)
        return Type::vec2;
    else if constexpr (std::is_same_v<T, tarn::vec3>)
        return Type::vec3;
    else if constexpr (std::is_same_v<T, tarn::vec4>)
        return Type::vec4;
    else if constexpr (std::is_same_v<T, tarn::ivec2>)
        return Type::ivec2;
    else if constexpr (std::is_same_v<T, tarn::ivec3>)
        return Type::ivec3;
    else if constexpr (std::is_same_v<T, tarn::ivec4>)
        return Type::ivec4;
    else if constexpr (std::is_same_v<T, tarn::mat3>)
        return Type::mat3;
    else {
        static_assert(std::is_same_v<T, tarn::mat4>, "no uniform type for this C++ type");
        return Type::mat4;
    }
}

template <typename T> void Uniform<T>::set(const T& value) const
{
    if constexpr (std::is_same_v<T, bool>) {
        const int asInteger = value ? 1 : 0;
        program_->store(slot_, Program::typeOf<T>(), 1, &asInteger, sizeof(asInteger));
    } else {
        program_->store(slot_, Program::typeOf<T>(), 1, &value, sizeof(T));
    }
}

template <typename T> void Program::setArray(std::string_view uniformName, std::span<const T> values)
{
    static_assert(!std::is_same_v<T, bool>);
    store(slot(uniformName), typeOf<T>(), static_cast<int>(values.size()), values.data(), values.size_bytes());
}

} // namespace tarn::gl

#include "gl/program.h"

#include "base/error.h"
#include "base/log.h"
#include "gl/api.h"
#include "gl/counters.h"
#include "gl/texture.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

namespace tarn::gl {

thread_local const Program* Program::current_ = nullptr;

namespace {

/// OpenGL 3.3 promises each stage 16 texture units; Texture edits through the one after them.
constexpr int unitCount = 16;

/// "lights" for "lights[0]" and "lights[3]"
std::string_view withoutIndex(std::string_view name)
{
    return !name.empty() && name.back() == ']' ? name.substr(0, name.rfind('[')) : name;
}

bool isSampler(GLenum type)
{
    switch (type) {
    case GL_SAMPLER_2D:
    case GL_SAMPLER_CUBE:
    case GL_SAMPLER_2D_SHADOW:
    case GL_SAMPLER_CUBE_SHADOW:
    case GL_SAMPLER_2D_MULTISAMPLE:
    case GL_SAMPLER_2D_ARRAY:
    case GL_SAMPLER_2D_ARRAY_SHADOW:
    case GL_SAMPLER_3D:
    case GL_SAMPLER_1D:
    case GL_SAMPLER_BUFFER: return true;
    default: return false;
    }
}

std::optional<int> find(const std::vector<std::pair<std::string, int>>& table, std::string_view name)
{
    for (const auto& [key, value] : table) {
        if (key == name) return value;
    }
    return std::nullopt;
}

void bindBlocks(Name program, const Bindings& bindings, const std::string& programName)
{
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<GLchar, 256> name{};
        glGetActiveUniformBlockName(program, i, static_cast<GLsizei>(name.size()), nullptr, name.data());
        const std::optional<int> binding = find(bindings.blocks, name.data());
        if (!binding) {
            throw Error("program \"{}\": uniform block {} has no binding index; add it to the bindings of the shader "
                        "library",
                        programName, name.data());
        }
        glUniformBlockBinding(program, i, static_cast<GLuint>(*binding));
    }
}

} // namespace

Program::Program(std::string name, std::shared_ptr<FirstUses> firstUses)
    : name_(std::move(name)), firstUses_(std::move(firstUses))
{}

Program::~Program()
{
    if (current_ == this) current_ = nullptr;
}

Program::ActiveMap Program::activeUniforms(Name program)
{
    ActiveMap active;
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<GLchar, 256> name{};
        GLint elements = 0;
        GLenum type = 0;
        glGetActiveUniform(program, i, static_cast<GLsizei>(name.size()), nullptr, &elements, &type, name.data());
        const bool isInBlock = glGetUniformLocation(program, name.data()) < 0;
        if (!isInBlock) active.emplace(withoutIndex(name.data()), Active{type, elements});
    }
    return active;
}

Program::NameMap<int> Program::assignUnits(Name program, const ActiveMap& active, const Bindings& bindings,
                                           const std::string& programName)
{
    std::set<std::string> samplers; // sorted: the same program has the same units on every driver
    for (const auto& [name, uniform] : active) {
        if (isSampler(uniform.glType)) samplers.insert(name);
    }
    NameMap<int> units;
    std::set<int> taken;
    for (const std::string& name : samplers) {
        const std::optional<int> unit = find(bindings.samplers, name);
        if (!unit) continue;
        units[name] = *unit;
        taken.insert(*unit);
    }
    int next = 0;
    for (const std::string& name : samplers) {
        if (units.contains(name)) continue;
        while (taken.contains(next)) ++next;
        units[name] = next++;
    }
    glUseProgram(program);
    for (const auto& [name, unit] : units) {
        if (unit < 0 || unit >= unitCount) {
            throw Error("program \"{}\": sampler {} would need texture unit {}, there are {}", programName, name, unit,
                        unitCount);
        }
        glUniform1i(glGetUniformLocation(program, name.c_str()), unit);
    }
    return units;
}

void Program::adopt(Object linked, const Bindings& bindings)
{
    const ActiveMap active = activeUniforms(linked.name());
    std::vector<Slot> slots = slots_;
    for (Slot& s : slots) {
        locate(s, linked.name(), active);
        if (s.type) checkFits(s, *s.type, s.count);
        s.dirty = s.type.has_value();
    }
    bindBlocks(linked.name(), bindings, name_);
    const auto restore = [&] { glUseProgram(current_ ? current_->object_.name() : 0); };
    NameMap<int> units;
    try {
        units = assignUnits(linked.name(), active, bindings, name_);
    } catch (...) {
        restore();
        throw;
    }
    const bool isReload = static_cast<bool>(object_);
    object_ = std::move(linked);
    active_ = active;
    units_ = std::move(units);
    slots_ = std::move(slots);
    missing_.clear();
    anyDirty_ = true;
    used_ = false;
    restore();
    if (current_ == this) use();
    if (isReload) ++generation_;
}

void Program::use() const
{
    count(Call::programBind);
    if (!used_) used_ = !firstUses_->next || firstUses_->next(*this);
    glUseProgram(object_.name());
    current_ = this;
    if (!anyDirty_) return;
    for (Slot& s : slots_) {
        if (s.dirty) upload(s);
    }
    anyDirty_ = false;
}

int Program::slot(std::string_view uniformName)
{
    if (const auto known = slotIndex_.find(uniformName); known != slotIndex_.end()) return known->second;
    Slot s;
    s.name = uniformName;
    locate(s, object_.name(), active_);
    if (s.location < 0) noteMissing("uniform", uniformName);
    const int index = static_cast<int>(slots_.size());
    slots_.push_back(std::move(s));
    slotIndex_.emplace(uniformName, index);
    return index;
}

void Program::locate(Slot& s, Name program, const ActiveMap& active)
{
    gl::count(Call::stateQuery);
    s.location = glGetUniformLocation(program, s.name.c_str());
    s.glType = 0;
    s.capacity = 0;
    if (s.location < 0) return;
    const auto found = active.find(withoutIndex(s.name));
    if (found == active.end()) return;
    s.glType = found->second.glType;
    s.capacity = found->second.count;
}

void Program::checkFits(const Slot& s, Type type, int count) const
{
    if (s.location < 0) return;
    constexpr std::array<GLenum, 11> glTypes = {GL_BOOL,       GL_INT,        GL_FLOAT,     GL_FLOAT_VEC2,
                                                GL_FLOAT_VEC3, GL_FLOAT_VEC4, GL_INT_VEC2,  GL_INT_VEC3,
                                                GL_INT_VEC4,   GL_FLOAT_MAT3, GL_FLOAT_MAT4};
    constexpr std::array<const char*, 11> names = {"bool",  "int",   "float", "vec2", "vec3", "vec4",
                                                   "ivec2", "ivec3", "ivec4", "mat3", "mat4"};
    const auto index = static_cast<std::size_t>(type);
    if (glTypes[index] != s.glType) {
        throw Error("program \"{}\": uniform {} is declared with another type than the {} it is set to", name_, s.name,
                    names[index]);
    }
    if (count > s.capacity) {
        throw Error("program \"{}\": uniform {} has {} elements and is set to {}", name_, s.name, s.capacity, count);
    }
}

void Program::store(int slotNumber, Type type, int count, const void* data, std::size_t bytes)
{
    Slot& s = slots_[static_cast<std::size_t>(slotNumber)];
    checkFits(s, type, count);
    const bool isSame = s.type == type && s.count == count && s.value.size() == bytes &&
                        (bytes == 0 || std::memcmp(s.value.data(), data, bytes) == 0);
    if (isSame) return;
    const auto* begin = static_cast<const std::byte*>(data);
    s.type = type;
    s.count = count;
    s.value.assign(begin, begin + bytes);
    s.dirty = true;
    if (current_ == this)
        upload(s);
    else
        anyDirty_ = true;
}

void Program::upload(Slot& s) const
{
    s.dirty = false;
    if (s.location < 0 || s.count == 0) return;
    gl::count(Call::uniformUpload);
    const auto* floats = reinterpret_cast<const GLfloat*>(s.value.data());
    const auto* integers = reinterpret_cast<const GLint*>(s.value.data());
    switch (*s.type) {
    case Type::boolean:
    case Type::integer: glUniform1iv(s.location, s.count, integers); break;
    case Type::scalar: glUniform1fv(s.location, s.count, floats); break;
    case Type::vec2: glUniform2fv(s.location, s.count, floats); break;
    case Type::vec3: glUniform3fv(s.location, s.count, floats); break;
    case Type::vec4: glUniform4fv(s.location, s.count, floats); break;
    case Type::ivec2: glUniform2iv(s.location, s.count, integers); break;
    case Type::ivec3: glUniform3iv(s.location, s.count, integers); break;
    case Type::ivec4: glUniform4iv(s.location, s.count, integers); break;
    case Type::mat3: glUniformMatrix3fv(s.location, s.count, GL_FALSE, floats); break;
    case Type::mat4: glUniformMatrix4fv(s.location, s.count, GL_FALSE, floats); break;
    }
}

namespace {

std::function<void(const Texture&)>& textureObserver()
{
    thread_local std::function<void(const Texture&)> observer;
    return observer;
}

} // namespace

void observeTextures(std::function<void(const Texture&)> observer) { textureObserver() = std::move(observer); }

void Program::texture(std::string_view samplerName, const Texture& texture)
{
    const std::optional<int> unit = samplerUnit(samplerName);
    if (!unit) {
        noteMissing("sampler", samplerName);
        return;
    }
    texture.bind(*unit);
    if (textureObserver()) textureObserver()(texture);
}

std::optional<int> Program::samplerUnit(std::string_view samplerName) const
{
    const auto found = units_.find(samplerName);
    return found == units_.end() ? std::nullopt : std::optional(found->second);
}

void Program::noteMissing(std::string_view what, std::string_view missingName)
{
    if (missing_.contains(missingName)) return;
    missing_.emplace(missingName, true);
    log::debug("program \"{}\" does not use a {} {}", name_, what, missingName);
}

std::optional<int> Program::blockSize(std::string_view blockName) const
{
    const GLuint index = glGetUniformBlockIndex(object_.name(), std::string(blockName).c_str());
    if (index == GL_INVALID_INDEX) return std::nullopt;
    GLint size = 0;
    glGetActiveUniformBlockiv(object_.name(), index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    return size;
}

std::optional<int> Program::blockOffset(std::string_view memberName) const
{
    const std::string name(memberName);
    const GLchar* text = name.c_str();
    GLuint index = GL_INVALID_INDEX;
    glGetUniformIndices(object_.name(), 1, &text, &index);
    if (index == GL_INVALID_INDEX) return std::nullopt;
    GLint offset = -1;
    glGetActiveUniformsiv(object_.name(), 1, &index, GL_UNIFORM_OFFSET, &offset);
    return offset < 0 ? std::nullopt : std::optional(offset);
}

} // namespace tarn::gl

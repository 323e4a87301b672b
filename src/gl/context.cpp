#include "gl/context.h"

#include "base/error.h"
#include "base/log.h"
#include "gl/api.h"

#include <atomic>
#include <mutex>
#include <string_view>

namespace tarn::gl {

namespace {

Capabilities current;
std::atomic<int> errorCount = 0;
std::mutex errorMutex;
std::string latestError;

void GLAPIENTRY receiveMessage(GLenum source, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text,
                               const void*)
{
    // The compiler's own complaints are reported by ShaderLibrary, with the names of the files.
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    const std::string message = length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length));
    if (type != GL_DEBUG_TYPE_ERROR) {
        log::debug("OpenGL: {}", message);
        return;
    }
    ++errorCount;
    const std::lock_guard lock(errorMutex);
    // A broken draw call says the same every frame.
    if (message != latestError) log::error("OpenGL: {}", message);
    latestError = message;
}

void listen(bool debug)
{
    if (!current.debug) return;
    glEnable(GL_DEBUG_OUTPUT);
    if (debug) glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(receiveMessage, nullptr);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
    glDebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    if (!debug) return;
    glDebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    glDebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    glDebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_PERFORMANCE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
}

/// GLEW ends with an error when there is no GLX although every OpenGL function was loaded: 3 under OSMesa, 4
/// under EGL and Wayland. So its verdict counts only together with a look at the functions themselves.
void loadFunctions(const std::string& origin)
{
    glewExperimental = GL_TRUE;
    const GLenum code = glewInit();
    const bool acceptable =
        code == GLEW_OK || code == GLEW_ERROR_GLX_VERSION_11_ONLY || code == GLEW_ERROR_NO_GLX_DISPLAY;
    if (!acceptable) {
        throw Error("{} gave a context, but its OpenGL functions cannot be loaded: {}", origin,
                    reinterpret_cast<const char*>(glewGetErrorString(code)));
    }
    if (!glGetStringi || !glGenVertexArrays || !glUniformBlockBinding || !glTexImage2DMultisample || !glQueryCounter ||
        !glVertexAttribDivisor) {
        throw Error("{} gave a context without the functions of OpenGL 3.3; update the graphics driver", origin);
    }
    while (glGetError() != GL_NO_ERROR) {
        // GLEW asks questions that a core profile refuses.
    }
}

int integer(GLenum what)
{
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

std::string string(GLenum what)
{
    const auto* text = reinterpret_cast<const char*>(glGetString(what));
    return text ? text : "unknown";
}

Capabilities askCapabilities()
{
    Capabilities answer;
    answer.debug = (GLEW_KHR_debug || GLEW_VERSION_4_3) && glDebugMessageCallback && glObjectLabel;
    if (GLEW_EXT_texture_filter_anisotropic) {
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &answer.maxAnisotropy);
    }
    answer.maxSamples = integer(GL_MAX_SAMPLES);
    answer.maxTextureSize = integer(GL_MAX_TEXTURE_SIZE);
    answer.maxArrayLayers = integer(GL_MAX_ARRAY_TEXTURE_LAYERS);
    answer.llvmpipe = string(GL_RENDERER).find("llvmpipe") != std::string::npos;
    return answer;
}

const char* errorName(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM: return "invalid enum";
    case GL_INVALID_VALUE: return "invalid value";
    case GL_INVALID_OPERATION: return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "invalid framebuffer operation";
    case GL_OUT_OF_MEMORY: return "out of memory";
    default: return "unknown error";
    }
}

} // namespace

void Context::initialise(bool debug)
{
    loadFunctions(origin_);
    const int version = 10 * integer(GL_MAJOR_VERSION) + integer(GL_MINOR_VERSION);
    if (version < 33) {
        throw Error("{} gives OpenGL {} on {}; Tarn needs 3.3", origin_, this->version(), string(GL_RENDERER));
    }
    current = askCapabilities();
    listen(debug);
    listening_ = true;
}

void Context::listenOnce()
{
    if (listening_) return;
    listening_ = true;
    listen(false);
}

std::string Context::renderer() const { return string(GL_RENDERER); }

std::string Context::version() const { return string(GL_VERSION); }

bool Context::isSoftware() const
{
    const std::string name = renderer();
    for (const std::string_view software : {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software Rasterizer"}) {
        if (name.find(software) != std::string::npos) return true;
    }
    return false;
}

const Capabilities& capabilities() { return current; }

int debugErrorCount() { return errorCount; }

std::string lastDebugError()
{
    const std::lock_guard lock(errorMutex);
    return latestError;
}

void checkErrors(const char* where)
{
    std::string names;
    // A lost context may answer with errors for ever.
    for (int i = 0; i < 16; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        names += names.empty() ? "" : ", ";
        names += errorName(error);
    }
    if (!names.empty()) throw Error("OpenGL error in {}: {}", where, names);
}

} // namespace tarn::gl

// How often OpenGL is called, by kind: what a frame costs the driver beside its triangles. Every wrapper of
// this folder counts its own calls.
//
//     const gl::Counters before = gl::counters();
//     … draw …
//     const gl::Counters frame = gl::counters() - before;
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tarn::gl {

enum class Call {
    draw,            ///< a call that draws, however many parts it draws
    programBind,     ///< glUseProgram
    textureBind,     ///< glBindTexture
    framebufferBind, ///< glBindFramebuffer
    vertexArrayBind, ///< glBindVertexArray
    stateChange,     ///< apply(State): the fixed functions, set as a whole
    uniformUpload,   ///< glUniform*
    bufferUpload,    ///< glBufferData, glBufferSubData
    clear,           ///< glClearBuffer*
    blit,            ///< glBlitFramebuffer
    stateQuery,      ///< glGet*, which a threaded driver has to wait for
    queryResult,     ///< glGetQueryObject*
    readBack,        ///< glReadPixels, glGetTexImage
};
inline constexpr std::size_t callCount = 13;

/// As they stand in results: "draw_calls".
inline constexpr std::array<std::string_view, callCount> callNames = {"draw_calls",
                                                                      "program_binds",
                                                                      "texture_binds",
                                                                      "framebuffer_binds",
                                                                      "vertex_array_binds",
                                                                      "state_changes",
                                                                      "uniform_uploads",
                                                                      "buffer_uploads",
                                                                      "clears",
                                                                      "blits",
                                                                      "state_queries",
                                                                      "query_results",
                                                                      "read_backs"};

struct Counters {
    std::array<std::uint64_t, callCount> calls{};

    std::uint64_t operator[](Call call) const { return calls[static_cast<std::size_t>(call)]; }
    Counters operator-(const Counters& earlier) const
    {
        Counters difference;
        for (std::size_t i = 0; i < callCount; ++i) difference.calls[i] = calls[i] - earlier.calls[i];
        return difference;
    }
};

/// Of this thread, since it began.
inline Counters& counters()
{
    thread_local Counters instance;
    return instance;
}

/// One more call.
inline void count(Call call) { ++counters().calls[static_cast<std::size_t>(call)]; }

} // namespace tarn::gl

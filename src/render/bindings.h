// Which binding index each uniform block of shaders/shared/blocks.glsl has, the same in every program.
#pragma once

#include "gl/shader_library.h"

namespace tarn {

enum class BlockIndex { frame = 0, view = 1, waves = 2, sun = 3 };

inline gl::Bindings shaderBindings()
{
    return {.blocks = {{"FrameBlock", static_cast<int>(BlockIndex::frame)},
                       {"ViewBlock", static_cast<int>(BlockIndex::view)},
                       {"WavesBlock", static_cast<int>(BlockIndex::waves)},
                       {"SunBlock", static_cast<int>(BlockIndex::sun)}},
            .samplers = {}};
}

} // namespace tarn

// The option of a target's depth as OpenGL names it.
#pragma once

#include "gl/format.h"
#include "plan/options.h"

namespace tarn {

inline gl::Format glFormat(DepthFormat format)
{
    switch (format) {
    case DepthFormat::depth16: return gl::Format::depth16;
    case DepthFormat::depth24: return gl::Format::depth24;
    case DepthFormat::depth32f: return gl::Format::depth32f;
    }
    return gl::Format::depth24;
}

} // namespace tarn

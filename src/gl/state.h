// The fixed-function state of a pass, set as a whole so that no pass inherits from the one before:
//
//     gl::apply({.cull = Cull::back, .clipDistances = 1});
#pragma once

#include "base/math.h"

#include <optional>

namespace tarn::gl {

enum class DepthTest { off, less, lessEqual, equal, always, greater };
enum class Cull { none, back, front };
enum class Blend { none, alpha, premultiplied, add };

/// Whole pixels of a framebuffer.
struct PixelRect {
    ivec2 lower{0}, size{0};
};

struct State {
    DepthTest depthTest = DepthTest::less;
    bool depthWrite = true;
    bool depthClamp = false; ///< geometry nearer than the near plane is kept: shadow casters
    Cull cull = Cull::none;
    bool clockwiseFront = false; ///< true for a mirrored view
    Blend blend = Blend::none;
    /// gl_ClipDistance[0 … n-1] that clip. A shader that writes more must write them positive: Mesa's
    /// llvmpipe (22.3) clips by every distance that is written.
    int clipDistances = 0;
    bool colourWrite = true;
    bool srgbEncode = false; ///< encode when writing to an sRGB target
    bool alphaToCoverage = false;
    bool wireframe = false;
    bool shaderPointSize = false;       ///< points are as large as gl_PointSize says
    vec2 depthOffset{0.0f};             ///< slope factor and constant units
    std::optional<PixelRect> scissor{}; ///< beside it nothing is drawn
};

/// Sets everything there is in State, plus what never changes: no stencil, no dithering,
/// filtering across the edges of cube maps, rows of pixels packed.
void apply(const State& state);

/// What of the last applied State may be written. Remembered, since asking OpenGL makes a threaded driver wait.
struct WriteMasks {
    bool colour = true;
    bool depth = true;
};
WriteMasks writeMasks();

} // namespace tarn::gl

// Whether the scene hides the water. Of a frame that draws it, the water pass itself tells; of one in which it may be
// hidden, the slab that its surface moves in is held against the frame's own depth, so that the answer is never one of
// another frame.
#pragma once

#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "gl/visibility_query.h"
#include "base/math.h"

#include <memory>

namespace tarn {

class HiddenWaterPass {
public:
    explicit HiddenWaterPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// Asks for the slab in the depth that the frame holds. The main view's ViewBlock must be bound.
    /// @param slab that the surface moves in, world (waterBounds)   @param eye outside of it
    void ask(const gl::Target& frame, const Bounds& slab, const vec3& eye);
    void prepare();

    /// Its last scope tells whether the water was seen: ask()'s, or one around the water pass.
    gl::VisibilityQuery& query() { return query_; }

    /// Whether no sample of the water passed the depth test when it was last asked; the newest answer that has come in.
    bool wasHidden();

private:
    gl::ShaderLibrary& shaders_;
    std::shared_ptr<gl::Program> program_;
    gl::VertexArray bare_{"water slab"};
    gl::VisibilityQuery query_;
    bool wasHidden_ = false;
};

} // namespace tarn

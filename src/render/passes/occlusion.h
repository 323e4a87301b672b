// What the scene hides, asked in a frame's own depth: what was hidden in the last frame is held against this one's as a
// box, and drawn only if some sample of that would be seen. So no answer is one of another frame, and a picture is
// never wrong; the last frame only tells for what asking is worth its cost. (In the manner of Bittner et al. 2004,
// "Coherent hierarchical culling", without its hierarchy.)
#pragma once

#include "base/math.h"
#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "gl/visibility_query.h"

#include <memory>
#include <optional>
#include <vector>

namespace tarn {

/// Draws boxes that write nothing.
class OcclusionPass {
public:
    explicit OcclusionPass(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// Asks the query whether anything within a box would be seen in the depth that the bound target holds. The view's
    /// ViewBlock must be bound.
    /// @param box world   @param eye of the view; canAsk() must hold
    void ask(gl::VisibilityQuery& query, const Bounds& box, const vec3& eye);
    void prepare();

    /// Whether the eye is so far outside of a box that the box, with room for rounding, still hides from it what is
    /// within.
    static bool canAsk(const Bounds& box, const vec3& eye);

private:
    gl::ShaderLibrary& shaders_;
    std::shared_ptr<gl::Program> program_;
    gl::VertexArray bare_{"occlusion box"};
};

/// Remembers which of the parts that are drawn in every frame were hidden when they were last drawn or asked for.
class HiddenParts {
public:
    /// Another number of parts begins anew: none is hidden.
    void count(std::size_t parts);
    /// Takes in the answers that have come. Once a frame, before anything is drawn.
    void takeAnswers();

    /// Whether nothing of what was drawn of them, when something last was, has been seen.
    bool wereAllHidden() const { return wereAllHidden_; }

    bool wasHidden(std::size_t part) const { return parts_[part].wasHidden; }
    /// Its condition for this frame: to be asked before it is drawn.
    gl::VisibilityQuery& asked(std::size_t part) { return parts_[part].asked; }
    /// To be counted while it is drawn; tells the next frame.
    gl::VisibilityQuery& drawn(std::size_t part)
    {
        parts_[part].isNew = true;
        return parts_[part].drawn;
    }

private:
    struct Part {
        bool wasHidden = false;
        bool isNew = false; ///< it was drawn since the last answer
        gl::VisibilityQuery asked, drawn;
    };
    std::vector<Part> parts_;
    bool wereAllHidden_ = false;
};

/// How a pass leaves out what is hidden, and what came of it in this frame.
struct Occlusion {
    OcclusionPass& boxes;
    HiddenParts& parts;
    bool asks = true;                 ///< else what is drawn is counted only
    std::size_t drawn = 0, asked = 0; ///< parts in view; those of them that the last frame hid
};

} // namespace tarn

#include "render/passes/hidden_water.h"

#include "gl/state.h"

#include <algorithm>

namespace tarn {

void HiddenWaterPass::prepare()
{
    if (!program_) program_ = shaders_.program("water slab", "passes/water_slab.vert", "passes/water_slab.frag");
}

void HiddenWaterPass::ask(const gl::Target& frame, const Bounds& slab, const vec3& eye)
{
    prepare();
    // Rounding may put the surface a little beside its bounds, and their edges beside its own on the screen.
    const float farthest = std::max(glm::distance(eye, slab.lower), glm::distance(eye, slab.upper));
    const vec3 room(std::min(0.01f + 1.0e-4f * farthest, 0.5f * (eye.y - slab.upper.y)));
    gl::apply({.depthTest = gl::DepthTest::lessEqual, .depthWrite = false, .depthClamp = true, .colourWrite = false});
    frame.bind();
    program_->use();
    program_->set("slabLower", slab.lower - room);
    program_->set("slabUpper", slab.upper + room);
    gl::VisibilityQuery::Scope asking(query_);
    bare_.draw(gl::Primitive::triangles, 0, 36);
}

bool HiddenWaterPass::wasHidden()
{
    if (const std::optional<bool> seen = query_.poll()) wasHidden_ = !*seen;
    return wasHidden_;
}

} // namespace tarn

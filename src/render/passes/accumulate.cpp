#include "render/passes/accumulate.h"

#include "gl/state.h"

#include <utility>

namespace tarn {

const gl::Target& AccumulatePass::add(const gl::Target& newest, int sample)
{
    std::swap(means_[0], means_[1]);
    for (gl::Target& mean : means_) mean.ensure({.size = newest.size(), .colours = {gl::Format::rgba32f}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    means_[0].bind();
    if (!program_) program_ = shaders_.program("accumulate", "passes/fullscreen.vert", "passes/accumulate.frag");
    program_->use();
    program_->texture("newest", newest.colour());
    // What a target that was just made holds is anything, NaN too, and would outlive a weight of nothing.
    program_->texture("mean", sample > 1 ? means_[1].colour() : newest.colour());
    program_->set("part", 1.0f / static_cast<float>(sample));
    triangle_.draw();
    return means_[0];
}

} // namespace tarn

#include "render/passes/waterline.h"

#include "gl/state.h"

namespace tarn {

const gl::Texture& WaterlinePass::draw(const View& view, ivec2 size)
{
    if (!program_) program_ = shaders_.program("waterline", "passes/fullscreen.vert", "passes/waterline.frag");
    target_.ensure({.size = size, .colours = {gl::Format::rg8}, .filter = gl::Filter::nearest});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    target_.bind();
    program_->use();
    // Not by worldFromClip: near the eye a float inverse of it is wrong by more than a pixel.
    const mat4 worldFromView = glm::inverse(view.viewFromWorld);
    const ViewTangents tangents(view.clipFromView);
    const vec2 half = view.nearPlane / vec2(view.clipFromView[0][0], view.clipFromView[1][1]);
    const vec2 corner = view.nearPlane * tangents.middle - half;
    program_->set("nearCorner", vec3(worldFromView * vec4(corner, -view.nearPlane, 1.0f)));
    program_->set("nearAcross", 2.0f * half.x * vec3(worldFromView[0]));
    program_->set("nearUp", 2.0f * half.y * vec3(worldFromView[1]));
    triangle_.draw();
    return target_.colour();
}

} // namespace tarn

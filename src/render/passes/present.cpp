#include "render/passes/present.h"

#include "gl/state.h"

namespace tarn {

namespace {

const char* toneCurveFunction(FrameOptions::ToneCurve curve)
{
    switch (curve) {
    case FrameOptions::ToneCurve::linear: return "toneLinear";
    case FrameOptions::ToneCurve::reinhard: return "toneReinhard";
    case FrameOptions::ToneCurve::aces: return "toneAces";
    }
    return "toneLinear";
}

} // namespace

const gl::Target& PresentPass::draw(const gl::Texture& source, const gl::Texture* glow, const FrameOptions& options,
                                    DebugView view, bool luma)
{
    target_.ensure({.size = source.size(), .colours = {gl::Format::rgba8}});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    target_.bind();
    gl::Defines defines{{"DISPLAY", std::to_string(infoOf(view).display)},
                        {"TONE_CURVE", toneCurveFunction(options.toneCurve)}};
    if (glow) defines.emplace_back("GLOW", "1");
    if (luma) defines.emplace_back("LUMA", "1");
    auto& program = programs_[defines];
    if (!program) program = shaders_.program("present", "passes/fullscreen.vert", "passes/present.frag", defines);
    program->use();
    program->texture("hdrColour", source);
    program->set("exposure", options.exposure);
    if (glow) program->texture("glowColour", *glow);
    triangle_.draw();
    return target_;
}

} // namespace tarn

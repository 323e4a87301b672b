#include "render/passes/present.h"

#include "gl/state.h"

namespace tarn {

namespace {

/// How present.frag shows a view (its DISPLAY).
const char* displayCode(DebugView view)
{
    switch (view) {
    case DebugView::final:
    case DebugView::refractionColour:
    case DebugView::reflection: return "0";
    case DebugView::sceneDepth:
    case DebugView::refractionDepth:
    case DebugView::pathLength: return "1";
    case DebugView::positionU:
    case DebugView::positionW:
    case DebugView::positionA:
    case DebugView::reflectionHit: return "2";
    case DebugView::normals: return "3";
    case DebugView::fresnel: return "4";
    case DebugView::caustics: return "5";
    }
    return "0";
}

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
    gl::Defines defines{{"DISPLAY", displayCode(view)}, {"TONE_CURVE", toneCurveFunction(options.toneCurve)}};
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

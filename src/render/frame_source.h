// What draws the frames of a FrameThread: the renderer, or the draft that stands in for it while it is built.
#pragma once

#include "gl/framebuffer.h"
#include "gl/profiler.h"
#include "render/frame.h"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace tarn {

class Renderer;

/// All that a frame depends on beside the scene.
struct FrameRequest {
    Camera camera;
    double time = 0.0; ///< s
    ivec2 size{0};     ///< of the picture, or of one eye's, pixels
    DebugView view = DebugView::final;
    Options options;
    WaterBody water;
    int sample = 0; ///< FrameInput::sample
    /// Set by whoever asked when nobody waits for it any more; null: never.
    std::shared_ptr<const std::atomic<bool>> abandoned{};
    bool operator==(const FrameRequest&) const = default;
};

/// What a drawn frame comes with.
struct FrameDelivery {
    FrameReport report;
    std::vector<gl::PassTime> passes;
    double milliseconds = 0.0; ///< that the thread spent on drawing it
    std::string shaderError;   ///< "file:line: message", or ""
    Options options{};         ///< that were asked for
    int sample = 0;            ///< the same
};

class FrameSource {
public:
    virtual ~FrameSource() = default;
    /// Takes the request's options without drawing.
    virtual void prepare(const FrameRequest&) {}
    /// Returns false when the last picture is this one, too. May throw FrameAbandoned.
    virtual bool draw(const FrameRequest& request) = 0;
    /// What the last draw() made, as shown.
    virtual const gl::Framebuffer& picture() const = 0;
    virtual FrameDelivery delivery() const = 0;
    enum class Ahead { nothing, more, later };
    /// A small piece of work that can wait until a frame is delivered. Says whether there is more, or will be.
    virtual Ahead workAhead() { return Ahead::nothing; }
    /// Null when another thing draws.
    virtual Renderer* renderer() { return nullptr; }
};

} // namespace tarn

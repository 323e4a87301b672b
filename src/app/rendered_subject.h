// A configuration of the renderer as the benchmark measures it (measure/benchmark.h).
#pragma once

#include "app/session.h"
#include "measure/benchmark.h"

#include <string>

namespace tarn {

/// The picture that all configurations draw.
struct SubjectView {
    Camera camera;
    double time = 0.0; ///< of the first frame, s; the waves move on from frame to frame
    ivec2 size{0};     ///< pixels
};

/// All subjects share a renderer, so that textures and buffers are those of one program.
class RenderedSubject : public BenchSubject {
public:
    /// Keeps references to the session and the view.
    RenderedSubject(std::string name, Session& session, Settings settings, const SubjectView& view);

    std::string name() const override { return name_; }
    void draw(int index) override;
    std::vector<BenchPass> drawPasses(int index) override;

private:
    std::uint64_t triangles(const std::string& pass) const;

    std::string name_;
    Session& session_;
    Settings settings_;
    const SubjectView& view_;
    const FrameStats* stats_ = nullptr;
};

/// Draws a frame before each that counts: the subject before had targets of another size, and making them
/// anew is no part of this one's cost.
class SettledSubject : public RenderedSubject {
public:
    using RenderedSubject::RenderedSubject;
    void prepare(int index) override { draw(index); }
};

} // namespace tarn

// A configuration of the renderer as the benchmark measures it (measure/benchmark.h).
#pragma once

#include "app/session.h"
#include "measure/benchmark.h"

#include <array>
#include <string>
#include <vector>

namespace tarn {

/// The pictures that all configurations draw.
struct SubjectView {
    Camera camera;
    double time = 0.0; ///< of the first frame, s; the waves move on from frame to frame
    ivec2 size{0};     ///< pixels
    /// Of a flight (scene/flight.h) in place of the one above; empty: the eye stands still.
    std::vector<Camera> flight{};
    int frames = 1; ///< that the flight takes
};

/// Frames from one drawing of every target to the next.
int longestInterval(const Options& options);

/// All subjects share a renderer, so that textures and buffers are those of one program.
class RenderedSubject : public BenchSubject {
public:
    /// Keeps references to the session and the view.
    /// @param keepsPictures what stays as it is from frame to frame, a target or all of the picture, is no cost of a
    ///        setting, and is drawn; true: it is kept, as the plan says
    RenderedSubject(std::string name, Session& session, Settings settings, const SubjectView& view,
                    bool keepsPictures = false);

    std::string name() const override { return name_; }
    /// Draws a frame of its own after another subject's: targets of another size and maps that the other does without
    /// are made there, and what the rules of the plan know of the last frame they know of one with the same settings.
    void prepare(int index, bool followsItself) override;
    void draw(int index) override;
    std::vector<BenchPass> drawPasses(int index) override;

    /// In how many of the measured frames each rule of the plan applied, and how many there were.
    const std::array<int, ruleCount>& ruleFrames() const { return ruleFrames_; }
    int measuredFrames() const { return measuredFrames_; }
    /// Of the last frame.
    const FramePlan& plan() const { return plan_; }

private:
    std::uint64_t triangles(const std::string& pass) const;
    /// @param index of a frame, or of a moment between two
    void drawAt(double index);

    std::string name_;
    Session& session_;
    Settings settings_;
    const SubjectView& view_;
    const FrameReport* report_ = nullptr;
    FramePlan plan_;
    bool isMeasured_ = false; ///< the next frame that draw() draws
    std::array<int, ruleCount> ruleFrames_{};
    int measuredFrames_ = 0;
};

} // namespace tarn

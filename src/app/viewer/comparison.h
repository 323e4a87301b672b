// The reference beside the live picture: a line to slide between them, or a map of what the live one has wrong.
#pragma once

#include "app/live_picture.h"
#include "app/settings.h"
#include "app/viewer/comparison_state.h"
#include "gl/texture.h"
#include "measure/error_map.h"
#include "reference/picture.h"

#include <future>
#include <optional>
#include <string>

namespace tarn {

class Comparison {
public:
    Comparison(reference::Picture truth, const ReferenceView& view);

    ComparisonState& state() { return state_; }
    const ComparisonState& state() const { return state_; }

    /// Brings what is shown up to date. An error map has the frame rendered anew, at the reference's size, when the
    /// settings have changed since: by `picture`, and it is there some frames later.
    /// @param request of the frame that is shown
    void update(LivePicture& picture, const FrameRequest& request, const Settings& settings);

    /// Over the picture. Between ImGuiLayer::beginFrame and draw.
    void drawOverlay(float scale);
    /// Which error; for the panel.
    void drawChoice();
    /// The state's note, and the chosen error's figures where there are some.
    std::string note() const;

private:
    void updateReference(const FrameOptions& options);
    void updateMap(LivePicture& picture, const FrameRequest& request, const Settings& settings);
    void measure(LivePicture& picture, const FrameRequest& request);
    void takeMeasured();
    void drawSlider(float scale);

    reference::Picture truth_;
    ComparisonState state_;
    gl::Texture reference_, map_;
    std::string referenceKey_; ///< what reference_ was made with
    std::string measuredKey_;  ///< what used_ is, or is being, measured with
    std::future<WaterQuantities> measuring_;
    std::optional<ErrorKind> mapKind_;
    WaterQuantities used_;
    ErrorFigures figures_;
};

} // namespace tarn

// The reference beside the live picture: a line to slide between them, or a map of what the live one has wrong.
#pragma once

#include "app/settings.h"
#include "app/viewer/comparison_state.h"
#include "gl/texture.h"
#include "measure/error_map.h"
#include "reference/picture.h"

#include <optional>
#include <string>

namespace tarn
{

class Comparison
{
public:
    Comparison(reference::Picture truth, const ReferenceView& view);

    ComparisonState& state() { return state_; }
    const ComparisonState& state() const { return state_; }

    /// Brings what is shown up to date. An error map renders the frame anew, at the reference's size, when the settings
    /// have changed since. Before the frame itself is rendered.
    void update(Renderer& renderer, const Settings& settings);

    /// Over the picture. Between ImGuiLayer::beginFrame and draw.
    void drawOverlay(float scale);
    /// Which error; for the panel.
    void drawChoice();
    /// The state's note, and the chosen error's figures where there are some.
    std::string note() const;

private:
    void updateReference(const FrameOptions& options);
    void updateMap(Renderer& renderer, const Settings& settings);
    void drawSlider(float scale);

    reference::Picture truth_;
    ComparisonState state_;
    gl::Texture reference_, map_;
    std::string referenceKey_; ///< what reference_ was made with
    std::string measuredKey_;  ///< what used_ was measured with
    std::optional<ErrorKind> mapKind_;
    WaterQuantities used_;
    ErrorFigures figures_;
};

} // namespace tarn

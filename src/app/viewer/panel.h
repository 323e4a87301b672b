// The panel with every option, made from their visitor.
#pragma once

#include "base/fields.h"

#include <functional>
#include <string>

namespace tarn {

struct PanelResult {
    bool changed = false; ///< some field of the tree was set
    bool reset = false;   ///< the person wants the settings that the viewer started with
};

/// Between ImGuiLayer::beginFrame and draw.
/// @param above widgets to stand over the options, or nothing
PanelResult drawPanel(const FieldTree& tree, float scale, bool& open, const std::function<void()>& above = {});

/// What the last frame ran and left out, and why; folded until it is opened. Within drawPanel's `above`.
void drawPlan(const std::string& table);

} // namespace tarn

// What lies on top of the picture: figures, messages, help, and the bar while the scene loads.
// All between ImGuiLayer::beginFrame and draw.
#pragma once

#include "app/viewer/fly_camera.h"
#include "app/viewer/frame_rate.h"
#include "base/progress.h"

#include <string>

namespace tarn {

struct HudState {
    const FrameRate& rate;
    const FlyCamera& camera;
    std::string scene;
    std::string view;  ///< name of the debug view
    double time = 0.0; ///< of the waves, s
    bool paused = false;
    bool underwater = false;
    std::size_t triangles = 0;
    std::string stereo;      ///< how both eyes' pictures are shown, or ""
    std::string comparison;  ///< with a reference, or ""
    std::string governor{};  ///< what it chose and what that costs, or ""
    bool draft = false;      ///< what is shown stands in for the picture
    std::string building{};  ///< what is being built meanwhile, or ""
    std::string message;     ///< for a few seconds, or ""
    std::string shaderError; ///< "file:line: message", or ""
};

void drawHud(const HudState& state, float scale);
void drawHelp(float scale, bool& open);
void drawLoading(const SharedProgress::State& state, float scale);

/// "Tarn - lake - 34 fps - water 3.1 ms, …", with "(draft)" while the picture is one
std::string titleText(const HudState& state);

} // namespace tarn

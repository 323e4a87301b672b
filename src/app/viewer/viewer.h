// The window in which a person walks round the lake.
#pragma once

#include "app/command_line.h"
#include "app/live_picture.h"
#include "app/scene_setup.h"
#include "app/spare_memory.h"
#include "app/viewer/comparison.h"
#include "app/viewer/fly_camera.h"
#include "app/viewer/frame_rate.h"
#include "app/viewer/glfw_input.h"
#include "app/viewer/governed_settings.h"
#include "app/viewer/imgui_layer.h"
#include "app/viewer/scene_clock.h"
#include "gl/window.h"

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>

namespace tarn {

class Viewer {
public:
    /// Opens the window.
    explicit Viewer(const ViewCommand& command);

    /// Loads the scene and shows it until the person leaves.
    void run();

private:
    /// False when the person left meanwhile.
    bool load();
    void begin();
    void drawLoadingFrame(const SharedProgress::State& state);

    // showing.cpp: the picture is drawn elsewhere, and this thread waits for none of it.
    void waitForNews() const;
    FrameRequest request() const;
    bool nothingToAsk() const;
    void ask();
    void showPicture(ivec2 size);
    void redraw(ivec2 size);
    std::string buildingNote() const;
    void measure();
    void takeScreenshot();
    void sayScreenshot();
    void leave();

    // governing.cpp: with which settings it is drawn.
    void beginToGovern();
    void govern(ivec2 size);
    bool isDisturbed(ivec2 size);
    bool isStill() const;
    bool isAnswered() const;
    void noteDrawn();
    void buildAtRest();
    void toggleGovernor();

    void frame();
    void takeInput(double seconds);
    void obey(const KeyCommand& command);
    void jumpToCamera(int index);
    /// A reference is there, and one eye's picture to hold against it.
    bool compares() const { return comparison_ && !sceneSetup_.settings.options.stereo.isOn(); }
    void compareNext();
    void drawWidgets(const FrameReport& report);
    void say(const std::string& message);

    ViewCommand command_;
    std::optional<reference::Picture> truth_; ///< until the comparison has it
    // In this order, so that all GL objects are gone before the window's context is.
    gl::Window window_;
    GlfwInput input_;
    ImGuiLayer widgets_;
    SceneSetup sceneSetup_;
    Settings startSettings_;
    std::unique_ptr<Comparison> comparison_; ///< null: no reference was named
    SpareMemory spare_{sceneSetup_.scene};
    LivePicture picture_;
    std::optional<GovernedSettings> governed_; ///< once the scene is there
    GovernedSettings::Part part_;              ///< of the frame that is asked for
    std::shared_ptr<std::atomic<bool>> abandoned_ = std::make_shared<std::atomic<bool>>(false); ///< what was asked for
    bool disturbed_ = true; ///< since that was asked for
    int answeredAtPart_ = 0;
    std::optional<FrameRequest> asked_; ///< last
    double lastAsk_ = 0.0;              ///< steady seconds
    int answeredAtAsk_ = 0;
    Options building_;                                 ///< what programs are built for that a better picture needs
    std::shared_ptr<std::atomic<bool>> buildingStops_; ///< soon
    std::future<int> built_;                           ///< how many are there; negative: all
    int builtBefore_ = 0;
    float lastTargetMs_ = 0.0f; ///< before the governor was switched off
    /// What a person can change beside the settings, as it was when it was last looked at.
    struct Touched {
        Camera camera;
        ivec2 size{0};
        DebugView view = DebugView::final;
        bool paused = false;
        bool operator==(const Touched&) const = default;
    } touched_;

    FlyCamera camera_{Camera{}};
    SceneClock clock_;
    FrameRate rate_;
    DebugView view_ = DebugView::final;
    double lastFrame_ = 0.0; ///< steady seconds; 0 before the first
    double lastTitle_ = 0.0;
    double lastRedraw_ = 0.0; ///< steady seconds
    ivec2 redrawnSize_{0};
    double lastPicture_ = 0.0; ///< steady seconds of the renderer's last; 0: it rested since
    int answeredAtPicture_ = 0, pictures_ = 0;
    std::future<std::string> screenshot_; ///< what to say of it
    std::string message_;
    double messageUntil_ = 0.0;
    bool helpOpen_ = false, panelOpen_ = false;
    bool screenshotWanted_ = false;
    bool leaving_ = false;
};

} // namespace tarn

// The window in which a person walks round the lake.
#pragma once

#include "app/command_line.h"
#include "app/stage.h"
#include "app/viewer/comparison.h"
#include "app/viewer/fly_camera.h"
#include "app/viewer/frame_rate.h"
#include "app/viewer/glfw_input.h"
#include "app/viewer/governed_settings.h"
#include "app/viewer/imgui_layer.h"
#include "app/viewer/scene_clock.h"
#include "gl/profiler.h"
#include "gl/shader_library.h"
#include "gl/window.h"
#include "render/renderer.h"
#include "render/warm_up.h"

#include <memory>
#include <string>

namespace tarn
{

class Viewer
{
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
    void makeRenderer();
    void govern();
    void settingsChanged();
    bool isDisturbed(ivec2 size);
    void buildAtRest();

    void frame();
    void takeInput(double seconds);
    void obey(const KeyCommand& command);
    void jumpToCamera(int index);
    /// A reference is there, and one eye's picture to hold against it.
    bool compares() const { return comparison_ && !stage_.settings.options.stereo.isOn(); }
    void compareNext();
    void drawWidgets(const FrameStats& stats);
    void takeScreenshot();
    void say(const std::string& message);
    void measure(double seconds);

    ViewCommand command_;
    std::optional<reference::Picture> truth_; ///< until the comparison has it
    // In this order, so that all GL objects are gone before the window's context is.
    gl::Window window_;
    GlfwInput input_;
    ImGuiLayer widgets_;
    Stage stage_;
    Settings startSettings_;
    std::unique_ptr<gl::ShaderLibrary> shaders_;
    gl::Profiler profiler_;
    std::unique_ptr<Renderer> renderer_;
    std::optional<GovernedSettings> governed_; ///< once the scene is there
    GovernedSettings::Part part_;
    std::vector<WarmUpFrame> toBuild_; ///< of programs that a better picture needs, the next one last
    Options building_;                 ///< what they are built for
    std::unique_ptr<Comparison> comparison_; ///< null: no reference was named

    FlyCamera camera_{Camera{}};
    SceneClock clock_;
    FrameRate rate_;
    DebugView view_ = DebugView::final;
    /// What a person can change, as it was in the last frame.
    struct Touched {
        Camera camera;
        ivec2 size{0};
        DebugView view = DebugView::final;
        bool paused = false;
        bool operator==(const Touched&) const = default;
    } touched_;
    double lastFrame_ = 0.0; ///< steady seconds; 0 before the first
    double lastTitle_ = 0.0;
    std::string message_;
    double messageUntil_ = 0.0;
    bool helpOpen_ = false, panelOpen_ = false;
    bool screenshotWanted_ = false;
    bool leaving_ = false;
};

} // namespace tarn

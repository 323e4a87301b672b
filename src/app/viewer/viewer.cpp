#include "app/viewer/viewer.h"

#include "app/plan_report.h"
#include "app/program.h"
#include "app/viewer/display_guard.h"
#include "app/viewer/hud.h"
#include "app/viewer/loading.h"
#include "app/viewer/panel.h"
#include "app/viewer/stereo_view.h"
#include "base/error.h"
#include "base/log.h"
#include "gl/framebuffer.h"

#include <GLFW/glfw3.h>

#include <chrono>
#include <cmath>

namespace tarn {

namespace {

constexpr double loadingFrameSeconds = 1.0 / 30.0;
constexpr double messageSeconds = 4.0;
constexpr double idleSeconds = 0.2; // between looks at a window that shows nothing

double steadySeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void makeFullscreen(GLFWwindow* window)
{
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) throw Error("--fullscreen: this display has no monitor to fill; leave --fullscreen away");
    glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool visible(const gl::Window& window)
{
    const ivec2 size = window.framebufferSize();
    return size.x > 0 && size.y > 0 && glfwGetWindowAttrib(window.handle(), GLFW_VISIBLE) &&
           !glfwGetWindowAttrib(window.handle(), GLFW_ICONIFIED);
}

/// Before the window opens, so that a wrong file is told at once.
std::optional<reference::Picture> readReference(const std::filesystem::path& file)
{
    if (file.empty()) return std::nullopt;
    return reference::readPicture(file);
}

void toggle(bool& option) { option = !option; }

} // namespace

void runViewer(const ViewCommand& command) { Viewer(command).run(); }

Viewer::Viewer(const ViewCommand& command)
    : command_(command), truth_(readReference(command.reference)),
      window_({.title = "Tarn", .size = command.view.size, .vsync = command.vsync}), input_(window_.handle()),
      widgets_(window_.handle()), picture_(window_, glfwPostEmptyEvent), clock_(command.view.time)
{
    picture_.times().note(StartupEvent::context);
    guardDisplay();
    choosePreset(command_.scene.settings, window_);
    input_.setWidgets(&widgets_);
    if (command.fullscreen) makeFullscreen(window_.handle());
}

void Viewer::run()
{
    const bool loaded = load();
    while (loaded && !leaving_ && !window_.shouldClose()) {
        if (!visible(window_)) {
            glfwWaitEventsTimeout(idleSeconds);
            lastFrame_ = 0.0; // the time away is no frame
            continue;
        }
        waitForNews();
        frame();
        if (command_.frames > 0 && picture_.answered() >= command_.frames) break;
    }
    leave();
}

bool Viewer::load()
{
    BackgroundLoad loading(command_.scene);
    while (!loading.done()) {
        glfwWaitEventsTimeout(loadingFrameSeconds);
        for (const KeyCommand& command : input_.takeCommands())
            if (command.action == Action::leave) leaving_ = true;
        if (leaving_ || window_.shouldClose()) {
            glfwHideWindow(window_.handle()); // gone for the eye; the reader ends when it has read
            return false;
        }
        drawLoadingFrame(loading.progress());
    }
    sceneSetup_ = loading.take();
    beginToGovern();
    startSettings_ = sceneSetup_.settings;
    begin();
    picture_.show(sceneSetup_.scene,
                  compares() ? sceneSetup_.settings : governed_->drawn()); // a comparison is with the own settings
    return true;
}

/// At the reference's view and time, where there is a reference, unless the command line names others.
void Viewer::begin()
{
    const Camera chosen = chooseCamera(sceneSetup_.scene, command_.view.camera);
    camera_.jumpTo(chosen);
    if (!truth_) return;
    const ReferenceView view = referenceView(*truth_, sceneSetup_.scene, command_.reference);
    requireSameScene(*truth_, sceneSetup_, command_.reference);
    comparison_ = std::make_unique<Comparison>(*std::move(truth_), view);
    truth_.reset();
    if (!command_.view.camera.isGiven()) camera_.jumpTo(view.camera);
    clock_.holdAt(command_.view.timeGiven ? command_.view.time : view.time);
}

void Viewer::drawLoadingFrame(const SharedProgress::State& state)
{
    const ivec2 size = window_.framebufferSize();
    if (size.x < 1 || size.y < 1) return;
    widgets_.beginFrame();
    drawLoading(state, widgets_.scale());
    const gl::Framebuffer screen = gl::Framebuffer::window(size);
    screen.bind();
    screen.clearColour(vec4(0.08f, 0.12f, 0.15f, 1.0f));
    widgets_.draw();
    window_.swap();
}

void Viewer::frame()
{
    const double now = steadySeconds();
    const double seconds = lastFrame_ > 0.0 ? now - lastFrame_ : 0.0;
    lastFrame_ = now;
    clock_.advance(now);
    takeInput(seconds);

    const ivec2 size = window_.framebufferSize();
    if (size.x < 1 || size.y < 1) return;
    if (compares()) comparison_->state().look(camera_.camera(), clock_.time());
    govern(size);
    if (compares()) comparison_->update(picture_, request(), governed_->drawn());
    if (screenshotWanted_) takeScreenshot();
    showPicture(size);
}

void Viewer::takeInput(double seconds)
{
    for (const KeyCommand& command : input_.takeCommands()) obey(command);
    int windowWidth = 0, windowHeight = 0;
    glfwGetWindowSize(window_.handle(), &windowWidth, &windowHeight);
    const vec2 look = input_.takeLook();
    if (look != vec2(0.0f)) camera_.look(look, static_cast<float>(windowHeight));
    const double wheel = input_.takeWheel();
    if (wheel != 0.0) {
        camera_.changeSpeed(wheel);
        say(fmt::format("speed {:.2g} m/s", camera_.speed()));
    }
    camera_.move(input_.held().direction(), input_.held().fast(), seconds);
}

void Viewer::obey(const KeyCommand& command)
{
    Options& options = sceneSetup_.settings.options;
    const auto switched = [&](bool& option, const char* name) {
        toggle(option);
        say(fmt::format("{} {}", name, option ? "on" : "off"));
    };
    switch (command.action) {
    case Action::camera: return jumpToCamera(command.index);
    case Action::caustics: return switched(options.caustics.enabled, "caustics");
    case Action::underwater: return switched(options.underwater.enabled, "underwater effects");
    case Action::glow: return switched(options.glow.enabled, "glow");
    case Action::reflection: return switched(options.reflection.enabled, "reflection");
    case Action::refraction: return switched(options.refraction.enabled, "refraction");
    case Action::pause: return clock_.togglePause();
    case Action::nextView:
        view_ = static_cast<DebugView>((static_cast<int>(view_) + 1) % debugViewCount);
        return say(fmt::format("view: {}", debugViewNames[static_cast<std::size_t>(view_)]));
    case Action::stereo:
        options.stereo.output = nextStereo(options.stereo.output);
        return say(options.stereo.isOn() ? stereoText(options.stereo) : "stereo off");
    case Action::compare: return compareNext();
    case Action::sliderLeft:
    case Action::sliderRight:
        if (compares()) comparison_->state().moveSlider(command.action == Action::sliderRight ? 1 : -1);
        return;
    case Action::governor: return toggleGovernor();
    case Action::help: return toggle(helpOpen_);
    case Action::panel: return toggle(panelOpen_);
    case Action::screenshot: screenshotWanted_ = true; return;
    case Action::leave: leaving_ = true; return;
    default: return; // held keys: HeldKeys knows them
    }
}

void Viewer::jumpToCamera(int index)
{
    const std::vector<Camera>& cameras = sceneSetup_.scene.cameras;
    if (index >= static_cast<int>(cameras.size()))
        return say(fmt::format("the scene has {} camera{} only", cameras.size(), cameras.size() == 1 ? "" : "s"));
    const Camera& camera = cameras[static_cast<std::size_t>(index)];
    camera_.jumpTo(camera);
    say(fmt::format("camera {}", camera.name));
}

void Viewer::compareNext()
{
    if (!comparison_) return say("nothing to compare with; start with --reference FILE");
    if (!compares()) return say("the reference is one eye's picture; O until stereo is off");
    ComparisonState& state = comparison_->state();
    state.look(camera_.camera(), clock_.time()); // of now, not of the last frame
    if (!state.next()) return;
    camera_.jumpTo(state.view().camera);
    clock_.holdAt(state.view().time);
    say("back at the reference's view");
}

void Viewer::drawWidgets(const FrameReport& report)
{
    if (compares()) comparison_->drawOverlay(widgets_.scale());
    const double now = lastFrame_;
    const HudState hud{.rate = rate_,
                       .camera = camera_,
                       .scene = sceneSetup_.scene.name,
                       .view = debugViewNames[static_cast<std::size_t>(view_)],
                       .time = clock_.time(),
                       .paused = clock_.paused(),
                       .underwater = report.plan.underwater,
                       .triangles = report.triangles(),
                       .stereo = stereoText(sceneSetup_.settings.options.stereo),
                       .comparison = compares() ? comparison_->note() : "",
                       .governor = picture_.isFull() ? governed_->text(rate_.framesPerSecond()) : "",
                       .draft = !picture_.isFull(),
                       .building = buildingNote(),
                       .message = now < messageUntil_ ? message_ : "",
                       .shaderError = picture_.delivery().shaderError};
    drawHud(hud, widgets_.scale());
    if (helpOpen_) drawHelp(widgets_.scale(), helpOpen_);
    if (panelOpen_) {
        std::function<void()> choice;
        choice = [&] {
            if (compares()) comparison_->drawChoice();
            if (picture_.isFull()) drawPlan(toTable(report));
        };
        const PanelResult result = drawPanel(fieldTree(sceneSetup_.settings), widgets_.scale(), panelOpen_, choice);
        if (result.reset) sceneSetup_.settings = startSettings_;
    }
    // Window managers are slow with titles, and eyes are slower.
    if (now - lastTitle_ >= 0.5) {
        lastTitle_ = now;
        window_.setTitle(titleText(hud));
    }
}

void Viewer::say(const std::string& message)
{
    message_ = message;
    messageUntil_ = steadySeconds() + messageSeconds;
}

} // namespace tarn

#include "app/viewer/viewer.h"

#include "app/ladder_file.h"
#include "app/plan_report.h"
#include "app/program.h"
#include "app/version.h"
#include "app/viewer/display_guard.h"
#include "app/viewer/hud.h"
#include "app/viewer/loading.h"
#include "app/viewer/panel.h"
#include "app/viewer/screenshot.h"
#include "app/viewer/stereo_view.h"
#include "base/error.h"
#include "base/log.h"
#include "gl/framebuffer.h"
#include "plan/stereo.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace tarn
{

namespace
{

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

/// Runs a function at most thirty times a second while something else reports.
class DrawingProgress : public Progress
{
public:
    explicit DrawingProgress(std::function<void(const SharedProgress::State&)> draw) : draw_(std::move(draw))
    {
    }

    void report(double fraction, const std::string& what) override
    {
        shared_.report(fraction, what);
        const double now = steadySeconds();
        if (now - last_ < loadingFrameSeconds) return;
        last_ = now;
        draw_(shared_.state());
    }

private:
    std::function<void(const SharedProgress::State&)> draw_;
    SharedProgress shared_;
    double last_ = 0.0;
};

bool visible(const gl::Window& window)
{
    const ivec2 size = window.framebufferSize();
    return size.x > 0 && size.y > 0 && glfwGetWindowAttrib(window.handle(), GLFW_VISIBLE) &&
           !glfwGetWindowAttrib(window.handle(), GLFW_ICONIFIED);
}

/// What a frame took: on a card what the card did, or the processor where that was longer; waiting for the screen's refresh
/// is no work. 0: not known yet.
double frameMilliseconds(const gl::Profiler& profiler, double wallMs)
{
    if (profiler.isSynchronous()) return wallMs;
    for (const gl::PassTime& time : profiler.latest())
        if (time.name == "frame") return std::max(time.gpuMs, time.wallMs);
    return 0.0;
}

bool movesWithTime(const WaterBody& water)
{
    return water.present && (totalAmplitude(water) > 0.0f || water.normalMap.isSeen());
}

/// Before the window opens, so that a wrong file is told at once.
std::optional<reference::Picture> readReference(const std::filesystem::path& file)
{
    if (file.empty()) return std::nullopt;
    return reference::readPicture(file);
}

void toggle(bool& option)
{
    option = !option;
}

} // namespace

void runViewer(const ViewCommand& command)
{
    Viewer(command).run();
}

Viewer::Viewer(const ViewCommand& command)
    : command_(command), truth_(readReference(command.reference)),
      window_({.title = "Tarn", .size = command.view.size, .vsync = command.vsync}),
      input_(window_.handle()), widgets_(window_.handle()), clock_(command.view.time)
{
    guardDisplay();
    choosePreset(command_.scene.settings, window_);
    input_.setWidgets(&widgets_);
    if (command.fullscreen) makeFullscreen(window_.handle());
    profiler_.setSynchronous(
        window_.isSoftware()); // else the HUD would show when passes were asked for, not drawn
}

void Viewer::run()
{
    if (!load()) return;
    makeRenderer();
    for (int drawn = 0; !leaving_ && !window_.shouldClose();) {
        if (!visible(window_)) {
            glfwWaitEventsTimeout(idleSeconds);
            lastFrame_ = 0.0; // the time away is no frame
            continue;
        }
        if (part_.isFinal) glfwWaitEventsTimeout(idleSeconds); // nothing is left to be drawn
        else glfwPollEvents();
        frame();
        if (command_.frames > 0 && ++drawn >= command_.frames) break;
    }
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
    stage_ = loading.take();
    if (command_.fps) stage_.settings.options.frame.targetMs = *command_.fps > 0.0 ? static_cast<float>(1e3 / *command_.fps) : 0.0f;
    startSettings_ = stage_.settings;
    govern();
    begin();
    return true;
}

/// On a card several frames are under way at once.
void Viewer::govern()
{
    const std::string& name = stage_.scene.name;
    governed_.emplace(readLadder(command_.ladder.empty() ? shippedLadder() : command_.ladder), stage_.settings,
                      name.empty() ? stage_.scene.file.stem().string() : name,
                      GovernorTuning{.framesUnderWay = profiler_.isSynchronous() ? 1 : 5});
}

void Viewer::settingsChanged() { governed_->setOwn(stage_.settings); }

/// At the reference's view and time, where there is a reference, unless the command line names others.
void Viewer::begin()
{
    const Camera chosen = chooseCamera(stage_.scene, command_.view.camera);
    camera_.jumpTo(chosen);
    if (!truth_) return;
    const ReferenceView view = referenceView(*truth_, stage_.scene, command_.reference);
    warnOfOtherScene(*truth_, stage_.scene, command_.reference);
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

void Viewer::makeRenderer()
{
    DrawingProgress progress([this](const SharedProgress::State& state) {
        glfwPollEvents();
        drawLoadingFrame(state);
    });
    shaders_ = makeShaderLibrary();
    renderer_ =
        std::make_unique<Renderer>(stage_.scene, governed_->drawn().options, *shaders_, profiler_, &progress);
    renderer_->setOptions(governed_->drawn().options, stage_.settings.water);
    warmUp(*renderer_, stage_.settings.water, &progress);
    governed_->noteBuilt(governed_->drawn().options);
}

/// Since the last frame, by the person.
bool Viewer::isDisturbed(ivec2 size)
{
    const Touched touched{camera_.camera(), size, view_, clock_.paused()};
    const bool changed = !(touched == std::exchange(touched_, touched));
    return changed || input_.held().direction() != vec3(0.0f);
}

/// One tiny frame at a time, so that a key that is pressed meanwhile need not wait for all of them.
void Viewer::buildAtRest()
{
    const std::optional<Options> wanted = governed_->toBuild();
    if (!wanted) return toBuild_.clear();
    const WaterBody& water = stage_.settings.water;
    if (toBuild_.empty() || !(building_ == *wanted)) {
        toBuild_ = warmUpFrames(*wanted, water);
        std::reverse(toBuild_.begin(), toBuild_.end());
        building_ = *wanted;
    }
    drawWarmUp(*renderer_, toBuild_.back(), water);
    toBuild_.pop_back();
    if (toBuild_.empty()) governed_->noteBuilt(building_);
    renderer_->setOptions(governed_->drawn().options, water);
}

void Viewer::frame()
{
    const double now = steadySeconds();
    const double seconds = lastFrame_ > 0.0 ? now - lastFrame_ : 0.0;
    lastFrame_ = now;
    clock_.advance(now);
    takeInput(seconds);
    shaders_->pollChanges();

    const ivec2 size = window_.framebufferSize();
    if (size.x < 1 || size.y < 1) return;
    if (compares()) comparison_->state().look(camera_.camera(), clock_.time());
    const bool oneEye = !stage_.settings.options.stereo.isOn();
    part_ = governed_->next({.now = now,
                             .disturbed = isDisturbed(size),
                             .isStill = oneEye && view_ == DebugView::final &&
                                        (clock_.paused() || !movesWithTime(stage_.settings.water)),
                             .suspended = compares() && comparison_->state().shown() != ComparisonMode::off});
    if (part_.changed) renderer_->setOptions(governed_->drawn().options, stage_.settings.water);
    if (compares()) comparison_->update(*renderer_, governed_->drawn());
    const ivec2 pictureSize = eyeSizeFor(size, stage_.settings.options.stereo.output);
    const FrameStats& stats =
        renderer_->render({camera_.camera(), clock_.time(), pictureSize, view_, false, part_.sample});
    const bool isKept = stats.plan.rule(RuleId::keepFrame).applies;
    if (screenshotWanted_) takeScreenshot();
    renderer_->presentToWindow(size);
    if (!part_.isFinal) measure(seconds);

    widgets_.beginFrame();
    drawWidgets(stats);
    gl::Framebuffer::window(size).bind();
    widgets_.draw();
    window_.swap();
    const double drawn = frameMilliseconds(profiler_, 1e3 * (steadySeconds() - now));
    if (!isKept && drawn > 0.0 && toBuild_.empty()) // tiny frames between would count
        governed_->took({governed_->drawn().options, part_.sample, drawn, steadySeconds()});
    buildAtRest();
}

void Viewer::takeInput(double seconds)
{
    for (const KeyCommand& command : input_.takeCommands())
        obey(command);
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
    Options& options = stage_.settings.options;
    const auto switched = [&](bool& option, const char* name) {
        toggle(option);
        settingsChanged();
        say(fmt::format("{} {}", name, option ? "on" : "off"));
    };
    switch (command.action) {
    case Action::camera:
        return jumpToCamera(command.index);
    case Action::caustics:
        return switched(options.caustics.enabled, "caustics");
    case Action::underwater:
        return switched(options.underwater.enabled, "underwater effects");
    case Action::glow:
        return switched(options.glow.enabled, "glow");
    case Action::reflection:
        return switched(options.reflection.enabled, "reflection");
    case Action::refraction:
        return switched(options.refraction.enabled, "refraction");
    case Action::pause:
        return clock_.togglePause();
    case Action::nextView:
        view_ = static_cast<DebugView>((static_cast<int>(view_) + 1) % debugViewCount);
        return say(fmt::format("view: {}", debugViewNames[static_cast<std::size_t>(view_)]));
    case Action::stereo:
        options.stereo.output = nextStereo(options.stereo.output);
        settingsChanged();
        return say(options.stereo.isOn() ? stereoText(options.stereo) : "stereo off");
    case Action::compare:
        return compareNext();
    case Action::sliderLeft:
    case Action::sliderRight:
        if (compares()) comparison_->state().moveSlider(command.action == Action::sliderRight ? 1 : -1);
        return;
    case Action::governor: {
        const bool isOn = governed_->toggle();
        return say(isOn ? fmt::format("governor on: {:.3g} ms a frame", governed_->targetMs()) : "governor off: your own settings");
    }
    case Action::help:
        return toggle(helpOpen_);
    case Action::panel:
        return toggle(panelOpen_);
    case Action::screenshot:
        screenshotWanted_ = true;
        return;
    case Action::leave:
        leaving_ = true;
        return;
    default:
        return; // held keys: HeldKeys knows them
    }
}

void Viewer::jumpToCamera(int index)
{
    const std::vector<Camera>& cameras = stage_.scene.cameras;
    if (index >= static_cast<int>(cameras.size()))
        return say(
            fmt::format("the scene has {} camera{} only", cameras.size(), cameras.size() == 1 ? "" : "s"));
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

void Viewer::drawWidgets(const FrameStats& stats)
{
    if (compares()) comparison_->drawOverlay(widgets_.scale());
    const double now = lastFrame_;
    const HudState hud{.rate = rate_,
                       .camera = camera_,
                       .scene = stage_.scene.name,
                       .view = debugViewNames[static_cast<std::size_t>(view_)],
                       .time = clock_.time(),
                       .paused = clock_.paused(),
                       .underwater = stats.plan.underwater,
                       .triangles = stats.triangles(),
                       .stereo = stereoText(stage_.settings.options.stereo),
                       .comparison = compares() ? comparison_->note() : "",
                       .governor = governed_->text(rate_.framesPerSecond()),
                       .message = now < messageUntil_ ? message_ : "",
                       .shaderError = shaders_->lastError()};
    drawHud(hud, widgets_.scale());
    if (helpOpen_) drawHelp(widgets_.scale(), helpOpen_);
    if (panelOpen_) {
        std::function<void()> choice;
        choice = [&] {
            if (compares()) comparison_->drawChoice();
            drawPlan(toTable(stats.plan));
        };
        const PanelResult result = drawPanel(fieldTree(stage_.settings), widgets_.scale(), panelOpen_, choice);
        if (result.reset) stage_.settings = startSettings_;
        if (result.reset || result.changed) settingsChanged();
    }
    // Window managers are slow with titles, and eyes are slower.
    if (now - lastTitle_ >= 0.5) {
        lastTitle_ = now;
        window_.setTitle(titleText(hud));
    }
}

void Viewer::takeScreenshot()
{
    screenshotWanted_ = false;
    try {
        const std::filesystem::path file = nextScreenshot(std::filesystem::current_path());
        writeImage(file, renderer_->readDisplay(),
                   {{"tarn:version", versionText()}, {"tarn:settings", settingsJson(governed_->drawn())}});
        say("saved " + file.string());
        log::info("saved {}", file.string());
    } catch (const std::exception& error) { // a full disk is no reason to leave the lake
        say(error.what());
        log::error("{}", error.what());
    }
}

void Viewer::say(const std::string& message)
{
    message_ = message;
    messageUntil_ = steadySeconds() + messageSeconds;
}

void Viewer::measure(double seconds)
{
    std::vector<ShownTime> passes;
    for (const gl::PassTime& time : profiler_.latest()) {
        const bool gpu = time.gpuMs >= 0.0 && !profiler_.isSynchronous();
        if (time.name != "frame") passes.push_back({time.name, gpu ? time.gpuMs : time.wallMs});
    }
    rate_.add(seconds, passes);
}

} // namespace tarn

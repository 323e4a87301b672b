// How the viewer's thread shows what other threads draw.
#include "app/viewer/viewer.h"

#include "app/version.h"
#include "app/viewer/screenshot.h"
#include "app/viewer/stereo_view.h"
#include "base/error.h"
#include "base/log.h"
#include "gl/framebuffer.h"
#include "plan/stereo.h"

#include <GLFW/glfw3.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

namespace tarn {

namespace {

constexpr double inputSeconds = 1.0 / 60.0;  // between looks at held keys
constexpr double soonSeconds = 0.001;        // until a GPU has finished a picture
constexpr double widgetSeconds = 1.0 / 30.0; // between redraws of what a person uses
constexpr double figureSeconds = 0.25;       // of what a person reads
constexpr double patienceSeconds = 1.0;      // with threads that build a program when the person has left

double steadySeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string savePicture(const std::filesystem::path& folder, const Image& image, const std::string& settings)
{
    try {
        const std::filesystem::path file = nextScreenshot(folder);
        writeImage(file, image, {{"tarn:version", versionText()}, {"tarn:settings", settings}});
        log::info("saved {}", file.string());
        return "saved " + file.string();
    } catch (const std::exception& error) { // a full disk is no reason to leave the lake
        log::error("{}", error.what());
        return error.what();
    }
}

} // namespace

/// Until an event, a picture, or the next look at held keys.
void Viewer::waitForNews() const
{
    const double news = part_.isFinal && nothingToAsk() ? figureSeconds : inputSeconds;
    glfwWaitEventsTimeout(picture_.isPending() ? soonSeconds : news);
}

FrameRequest Viewer::request() const
{
    const ivec2 size = window_.framebufferSize();
    return {camera_.camera(),
            clock_.time(),
            eyeSizeFor(size, sceneSetup_.settings.options.stereo.output),
            view_,
            governed_->drawn().options,
            governed_->drawn().water,
            part_.sample,
            abandoned_};
}

/// The picture that is there is the one that is wanted.
bool Viewer::nothingToAsk() const
{
    return asked_ && picture_.isFull() && picture_.answered() > answeredAtAsk_ && *asked_ == request();
}

/// Now and then also for the same again: a shader may have been edited.
void Viewer::ask()
{
    if (nothingToAsk() && lastFrame_ - lastAsk_ < figureSeconds) return;
    lastAsk_ = lastFrame_;
    answeredAtAsk_ = picture_.answered();
    asked_ = request();
    picture_.ask(*asked_);
}

void Viewer::showPicture(ivec2 size)
{
    ask();
    const bool isNew = picture_.take();
    if (isNew) noteDrawn();
    spare_.release(picture_);
    measure();
    sayScreenshot();
    const double now = lastFrame_;
    const bool used = panelOpen_ || helpOpen_ || compares() || now < messageUntil_ || !picture_.hasPicture();
    const double patience = used ? widgetSeconds : figureSeconds;
    if (isNew || size != redrawnSize_ || now - lastRedraw_ >= patience) redraw(size);
}

void Viewer::redraw(ivec2 size)
{
    lastRedraw_ = lastFrame_;
    redrawnSize_ = size;
    if (!picture_.hasPicture()) return drawLoadingFrame(picture_.progress());
    const gl::Framebuffer screen = gl::Framebuffer::window(size);
    picture_.copyTo(screen);
    widgets_.beginFrame();
    drawWidgets(picture_.delivery().report);
    screen.bind();
    widgets_.draw();
    window_.swap();
}

std::string Viewer::buildingNote() const
{
    if (picture_.isBuilt()) return "";
    return (picture_.isFull() ? "" : "draft picture   ") + picture_.progress().what;
}

/// The time between the renderer's pictures, unless it rested between them; a draft's own time.
void Viewer::measure()
{
    const FrameDelivery& delivery = picture_.delivery();
    if (!picture_.isFull()) {
        if (picture_.hasPicture()) rate_.add(1e-3 * delivery.milliseconds, {});
        return;
    }
    const int answered = picture_.answered();
    if (answered == answeredAtPicture_) return;
    const double now = lastFrame_;
    const bool drew = picture_.pictures() != pictures_;
    pictures_ = picture_.pictures();
    answeredAtPicture_ = answered;
    if (!drew) { // nothing moves
        lastPicture_ = 0.0;
        return;
    }
    std::vector<ShownTime> passes;
    for (const gl::PassTime& time : delivery.passes) {
        const bool gpu = time.gpuMs >= 0.0 && !window_.isSoftware();
        if (time.name != "frame") passes.push_back({time.name, gpu ? time.gpuMs : time.wallMs});
    }
    rate_.add(lastPicture_ > 0.0 ? now - lastPicture_ : 1e-3 * delivery.milliseconds, passes);
    lastPicture_ = now;
}

/// Of the view as it is now, in the full quality, as soon as that can be drawn.
void Viewer::takeScreenshot()
{
    screenshotWanted_ = false;
    const auto promise = std::make_shared<std::promise<std::string>>();
    screenshot_ = promise->get_future();
    const std::filesystem::path folder = std::filesystem::current_path();
    FrameRequest wanted = request();
    wanted.abandoned = nullptr; // it is waited for
    picture_.post([promise, folder, request = std::move(wanted),
                   settings = settingsJson(governed_->drawn())](FrameSource& source) {
        source.draw(request);
        promise->set_value(savePicture(folder, source.renderer()->readDisplay(), settings));
    });
}

void Viewer::sayScreenshot()
{
    if (!screenshot_.valid() || screenshot_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    say(screenshot_.get());
}

/// The window is gone at once; threads end with the program or the frame that they are at. A driver's compiler cannot
/// be interrupted, so one that takes long is left to the end of the process.
void Viewer::leave()
{
    glfwHideWindow(window_.handle());
    picture_.stop();
    for (const double end = steadySeconds() + patienceSeconds; !picture_.hasEnded() && steadySeconds() < end;)
        glfwWaitEventsTimeout(0.01);
    if (picture_.hasEnded()) return;
    std::fflush(nullptr);
    _exit(0);
}

} // namespace tarn

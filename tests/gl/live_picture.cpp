// The picture that is there soon and then gets better: a draft, then what a renderer draws by itself.
#include "gl_test.h"

#include "app/live_picture.h"
#include "app/spare_memory.h"
#include "base/error.h"
#include "gl/api.h"
#include "render/gpu_scene.h"
#include "render/program_builder.h"
#include "render/renderer_source.h"
#include "render/warm_up.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace tarn::test {

namespace {

constexpr ivec2 size(48, 36);

/// A box that stands in a pond, with sun and waves.
Scene pond()
{
    Scene scene = flatLake(2.0f, 30.0f);
    addBox(scene, {-1.5f, -2.0f, -1.0f}, {1.0f, 1.5f, 1.0f}, 0);
    scene.sun = Sun{normalize(vec3(0.3f, 1.0f, 0.4f)), vec3(2.0f), false};
    scene.water.waves = {{0.02f, 2.0f, 0.4f, 0.0f, 0.0f}};
    return scene;
}

FrameRequest requestOf(const Scene& scene)
{
    FrameRequest request;
    request.camera.eye = vec3(2.0f, 3.0f, 8.0f);
    request.camera.target = vec3(0.0f);
    request.time = 0.5;
    request.size = size;
    request.options.sunlight.mapSize = 64;
    request.options.refraction.targetSize = request.options.reflection.targetSize = 32;
    request.options.caustics.photons = request.options.caustics.textureSize = 32;
    request.water = scene.water;
    return request;
}

/// Rows from the lowest, four bytes a pixel.
std::vector<std::uint8_t> bytesOf(const LivePicture& picture)
{
    gl::Target target("copy");
    target.ensure({.size = size, .colours = {gl::Format::rgba8}});
    picture.copyTo(target.framebuffer());
    return target.framebuffer().readBytes();
}

/// What a renderer draws that nothing else has to do with.
std::vector<std::uint8_t> plainBytes(const Scene& scene, const FrameRequest& request)
{
    TestRenderer test(scene, request.options);
    test.renderer.setOptions(request.options, request.water);
    test.renderer.render({request.camera, request.time, request.size, request.view});
    return test.renderer.display().readBytes();
}

template <typename Condition> bool becomes(const Condition& condition)
{
    constexpr int patience = 60'000; // ms; nothing is measured by it
    for (int i = 0; i < patience; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

double meanDifference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i]));
    return sum / static_cast<double>(a.size());
}

class Throwing : public FrameSource {
public:
    bool draw(const FrameRequest&) override { throw Error("no picture today"); }
    const gl::Framebuffer& picture() const override { return framebuffer_; }
    FrameDelivery delivery() const override { return {}; }

private:
    gl::Framebuffer framebuffer_;
};

} // namespace

TEST(LivePicture, EndsWithThePictureThatARendererDraws)
{
    const Scene scene = pond();
    FrameRequest request = requestOf(scene);
    LivePicture picture(testContext(), [] {});
    picture.show(scene, {request.options, request.water});
    ASSERT_TRUE(becomes([&] {
        picture.ask(request);
        picture.take();
        return picture.isFull();
    }));
    EXPECT_EQ(bytesOf(picture), plainBytes(scene, request));

    // Another view and other settings, while the programs that these need may not be there.
    request.camera.eye = vec3(-3.0f, -1.0f, 6.0f);
    request.options.glow.enabled = request.options.caustics.enabled = false;
    const std::vector<std::uint8_t> expected = plainBytes(scene, request);
    EXPECT_TRUE(becomes([&] {
        picture.ask(request);
        return picture.take() && bytesOf(picture) == expected;
    }));
    EXPECT_TRUE(becomes([&] {
        picture.take();
        return picture.isBuilt();
    })) << "the rest of the programs is built while nobody asks for a frame";
}

TEST(LivePicture, NeedsNoTexelsOnceTheSceneIsUploaded)
{
    Scene scene = pond();
    scene.images.push_back({"planks", 2, 1, 3, {200, 20, 20, 20, 200, 20}, {}});
    scene.materials.front().diffuseMap = 0;
    const FrameRequest request = requestOf(scene);
    const std::vector<std::uint8_t> expected = plainBytes(scene, request);
    SpareMemory spare(scene);
    LivePicture picture(testContext(), [] {});
    spare.release(picture);
    EXPECT_FALSE(scene.images.front().bytes.empty()) << "nothing is uploaded yet";
    picture.show(scene, {request.options, request.water});
    ASSERT_TRUE(becomes([&] {
        picture.ask(request);
        picture.take();
        spare.release(picture);
        return picture.isFull();
    }));
    EXPECT_TRUE(scene.images.front().bytes.empty());
    EXPECT_EQ(scene.images.front().size(), 6u);
    EXPECT_EQ(bytesOf(picture), expected);
}

TEST(LivePicture, EndsWhileProgramsAreBuilt)
{
    const Scene scene = pond();
    const FrameRequest request = requestOf(scene);
    for (const int wait : {0, 5, 50}) {
        LivePicture picture(testContext(), [] {});
        picture.show(scene, {request.options, request.water});
        picture.ask(request);
        std::this_thread::sleep_for(std::chrono::milliseconds(wait));
        picture.stop();
        EXPECT_TRUE(becomes([&] { return picture.hasEnded(); }));
        EXPECT_NO_THROW(picture.take());
    }
    LivePicture never(testContext(), [] {}); // whose scene is never read
    never.stop();
    EXPECT_TRUE(becomes([&] { return never.hasEnded(); }));
}

// Not the picture, but one that a person takes for the same view.
TEST(DraftRenderer, DrawsWhatThePictureWillShow)
{
    const Scene scene = pond();
    FrameRequest request = requestOf(scene);
    const auto uploaded = uploadScene(scene, request.options, nullptr);
    DraftRenderer draft;
    draft.show(DraftScene(*uploaded));
    // From the air, and from under water up through the surface.
    for (const auto& [eye, target] :
         {std::pair(vec3(2.0f, 3.0f, 8.0f), vec3(0.0f)), std::pair(vec3(0.0f, -1.8f, 3.0f), vec3(0.0f, 1.0f, 1.0f))}) {
        request.camera.eye = eye;
        request.camera.target = target;
        ASSERT_TRUE(draft.draw(request));
        gl::Target scaled("scaled");
        scaled.ensure({.size = size, .colours = {gl::Format::rgba8}});
        draft.picture().blitTo(scaled.framebuffer(), {.filter = gl::Filter::linear});
        const std::vector<std::uint8_t> drawn = scaled.framebuffer().readBytes();
        const std::vector<std::uint8_t> full = plainBytes(scene, request);
        EXPECT_LT(meanDifference(drawn, full), 30.0) << eye.y;
        std::vector<std::uint8_t> shifted = full; // a picture of something else is farther off
        std::rotate(shifted.begin(), shifted.begin() + static_cast<std::ptrdiff_t>(shifted.size() / 2), shifted.end());
        EXPECT_LT(meanDifference(drawn, full), 0.7 * meanDifference(drawn, shifted)) << eye.y;
    }
}

TEST(FrameThread, ThrowsWhereThePictureIsTakenWhatItsSourceThrew)
{
    const auto fails = [](FrameThread& thread) {
        try {
            return becomes([&] {
                thread.take();
                return false;
            });
        } catch (const Error& error) {
            return std::string(error.what()) == "no picture today";
        }
    };
    FrameThread whileMade(
        testContext().makeShared(),
        [](const StopSignal&) -> std::unique_ptr<FrameSource> { throw Error("no picture today"); }, [] {});
    EXPECT_TRUE(fails(whileMade));
    FrameThread whileDrawing(
        testContext().makeShared(), [](const StopSignal&) { return std::make_unique<Throwing>(); }, [] {});
    whileDrawing.ask({});
    EXPECT_TRUE(fails(whileDrawing));
}

// A job may draw what is then asked for: the source finds it unchanged, and yet nobody has seen it.
TEST(FrameThread, ShowsWhatAJobHasDrawn)
{
    const Scene scene = pond();
    const FrameRequest request = requestOf(scene);
    FrameThread thread(
        testContext().makeShared(),
        [&](const StopSignal&) {
            return std::make_unique<RendererSource>(uploadScene(scene, request.options, nullptr), request.options,
                                                    request.water, nullptr);
        },
        [] {});
    thread.post([&](FrameSource& source) { source.draw(request); });
    thread.ask(request);
    EXPECT_TRUE(becomes([&] { return thread.take(); }));
}

// What a rehearsal has built for one view a renderer beside it does not build again, for any.
TEST(Rehearsal, LeavesNothingToBuild)
{
    const Scene scene = pond();
    const FrameRequest request = requestOf(scene);
    const auto shaders = makeShaderLibrary();
    gl::Profiler profiler;
    const auto uploaded = uploadScene(scene, request.options, nullptr);
    Renderer renderer(uploaded, request.options, *shaders, profiler);
    Rehearsal rehearsal(uploaded, *shaders, request.options, request.water, nullptr);
    std::string unused; // names
    const auto draw = [&](const vec3& eye) {
        unused.clear();
        shaders->watchFirstUses([&](const gl::Program& program) {
            unused += program.name() + ", ";
            return true;
        });
        Camera camera = request.camera;
        camera.eye = eye;
        renderer.render({camera, request.time, request.size});
        shaders->watchFirstUses({});
    };
    rehearsal.build({request.camera, request.time, request.size});
    draw(request.camera.eye);
    EXPECT_EQ(unused, "");
    int steps = 0;
    while (rehearsal.buildOthers(2)) ++steps;
    EXPECT_GT(steps, 2) << "else there was nothing to build bit by bit";
    for (const vec3 eye : {vec3(0.0f, -1.0f, 8.0f), vec3(0.0f, 0.0f, 8.0f), vec3(0.0f, 5.0f, 0.1f)}) {
        draw(eye);
        EXPECT_EQ(unused, "") << eye.y;
    }
}

// Two that begin with different halves end with the same.
TEST(Rehearsal, BuildsEverythingInEitherOrder)
{
    const Scene scene = pond();
    const FrameRequest request = requestOf(scene);
    const auto uploaded = uploadScene(scene, request.options, nullptr);
    for (const auto order : {Rehearsal::Order::evenFirst, Rehearsal::Order::oddFirst}) {
        const auto shaders = makeShaderLibrary();
        gl::Profiler profiler;
        Renderer renderer(uploaded, request.options, *shaders, profiler);
        Rehearsal rehearsal(uploaded, *shaders, request.options, request.water, nullptr);
        rehearsal.build({request.camera, request.time, request.size}, order);
        std::string unused;
        shaders->watchFirstUses([&](const gl::Program& program) {
            unused += program.name() + ", ";
            return true;
        });
        renderer.render({request.camera, request.time, request.size});
        shaders->watchFirstUses({});
        EXPECT_EQ(unused, "");
    }
}

TEST(ProgramBuilder, EndsWithNothingLeftAndCanBeInterrupted)
{
    const Scene scene = pond();
    const FrameRequest request = requestOf(scene);
    const auto uploaded = uploadScene(scene, request.options, nullptr);
    glFinish(); // another context is to draw from it
    ProgramBuilder builder(testContext().makeShared(), uploaded);
    EXPECT_TRUE(builder.isDone());
    builder.begin({{request.options, request.water, Rehearsal::View{request.camera, request.time, request.size}}});
    EXPECT_FALSE(builder.isDone());
    EXPECT_TRUE(becomes([&] { return builder.isDone(); }));
    builder.begin({{request.options, request.water}});
    builder.begin({{request.options, request.water}}); // in place of the first
    EXPECT_FALSE(builder.isDone());
    builder.pause();
    EXPECT_TRUE(becomes([&] { return builder.isDone(); }));
    builder.begin({{request.options, request.water}}); // and is left in the middle of it
}

// In the thread that draws, programs of the second thread are drawn with at once, and then nothing is left.
TEST(FrameThread, BuildsInASecondThread)
{
    const Scene scene = pond();
    const FrameRequest request = requestOf(scene);
    std::unique_ptr<gl::Context> second = testContext().makeShared();
    FrameThread thread(
        testContext().makeShared(),
        [&](const StopSignal&) {
            return std::make_unique<RendererSource>(uploadScene(scene, request.options, nullptr), request.options,
                                                    request.water, nullptr, std::move(second));
        },
        [] {});
    thread.ask(request);
    EXPECT_TRUE(becomes([&] { return thread.take(); }));
    FrameRequest other = request;
    other.options.detail.pixels =
        2.0f; // asks for something else of the scene, which the second thread may be drawing from
    other.options.reflection.enabled = false;
    thread.ask(other);
    EXPECT_TRUE(becomes([&] { return thread.answered() == 2 && thread.isIdle(); }));
    EXPECT_TRUE(becomes([&] { return thread.take(); }));
}

} // namespace tarn::test

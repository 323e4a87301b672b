// Two eyes: what each sees through its oblique frustum, and how both are put together.
#include "gl_test.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "base/error.h"
#include "gl/shader_library.h"
#include "measure/disparity.h"
#include "optics/optics.h"
#include "plan/stereo.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tarn::test {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr ivec2 eyeSize(96, 72);

/// Boxes in the air and in a wavy, sunlit lake: every pass has something to do.
Scene livelyLake()
{
    Scene scene = flatLake(2.0f, 30.0f, 60.0f);
    scene.sun = Sun{normalize(vec3(1.0f, 2.0f, -1.0f)), vec3(5.0f), false};
    scene.water.waves = {{0.04f, 2.3f, 0.3f, 0.4f, 0.0f}, {0.02f, 0.9f, 1.7f, 1.1f, 0.0f}};
    const int red = addMaterial(scene, vec3(0.8f, 0.2f, 0.1f)), blue = addMaterial(scene, vec3(0.1f, 0.3f, 0.7f));
    addBox(scene, {-1.5f, -2.0f, -4.0f}, {-1.0f, 1.5f, -3.5f}, red);
    addBox(scene, {0.8f, -2.0f, -6.0f}, {1.4f, -1.2f, -5.0f}, blue);
    addBox(scene, {2.0f, -0.5f, -9.0f}, {4.0f, 3.0f, -8.0f}, blue);
    return scene;
}

Camera overTheLake()
{
    Camera camera;
    camera.eye = {0.0f, 1.5f, 2.0f};
    camera.target = {0.0f, 0.0f, -3.0f};
    camera.farPlane = 200.0f;
    return camera;
}

Options plain()
{
    Options options;
    options.frame.msaa = 1;
    return options;
}

Options stereoOf(Options options, StereoOptions::Output output, float separation = 0.3f)
{
    options.stereo.output = output;
    options.stereo.separation = separation;
    options.stereo.convergence = 4.0f;
    return options;
}

/// A part of a picture.
Image partOf(const Image& image, int from, int width)
{
    Image part{image.name, width, image.height, image.channels, {}, {}};
    for (int y = 0; y < image.height; ++y) {
        const auto begin = (static_cast<std::ptrdiff_t>(y) * image.width + from) * image.channels;
        const auto end = begin + static_cast<std::ptrdiff_t>(width) * image.channels;
        const auto take = [&](const auto& values, auto& to) {
            to.insert(to.end(), values.begin() + begin, values.begin() + end);
        };
        if (image.isFloat())
            take(image.floats, part.floats);
        else
            take(image.bytes, part.bytes);
    }
    return part;
}

/// The camera of a picture that is wider by so many pixels on either side, and the one of its right part.
struct Widened {
    Camera wide, part;
    ivec2 wideSize;
};
Widened widened(const Camera& camera, int pixels)
{
    Widened result{camera, camera, eyeSize + ivec2(2 * pixels, 0)};
    const float pixelTangent = 2.0f * std::tan(0.5f * camera.verticalFov) / static_cast<float>(eyeSize.y);
    result.part.lensShift = static_cast<float>(pixels) * pixelTangent;
    return result;
}

/// Share of the pixels that differ by more than a tenth.
double differing(const Image& a, const Image& b)
{
    std::size_t count = 0, all = a.floats.size() / 4;
    EXPECT_EQ(a.floats.size(), b.floats.size());
    for (std::size_t i = 0; i < all; ++i) {
        float worst = 0.0f;
        for (std::size_t c = 0; c < 3; ++c) {
            const float x = a.floats[4 * i + c], y = b.floats[4 * i + c];
            worst = std::max(worst, std::abs(x - y) - 0.1f * std::max(std::abs(x), std::abs(y)));
        }
        count += worst > 0.01f;
    }
    return static_cast<double>(count) / static_cast<double>(all);
}

} // namespace

// The rays of an oblique frustum are those of a part of a wider upright one, wherever the eye is: over the water, under
// it, and with the surface across the near plane.
TEST(Stereo, AnObliqueFrustumShowsAPartOfAWiderPicture)
{
    const Scene scene = livelyLake();
    Camera over = overTheLake(), under = over, across = over;
    under.eye.y = -0.8f;
    under.target.y = -0.2f;
    across.eye.y = 0.02f;
    across.target.y = 0.1f;
    across.up = {0.7f, 0.7f, 0.0f}; // so that the waterline runs aslant, and a shift of it shows
    Options options = plain();
    options.glow.enabled = false; // its target is too small to be a part of another
    options.refraction.targetSize = options.reflection.targetSize = 1024; // a wider picture spreads them wider
    CheckedRenderer renderer(scene, options);
    for (const auto& [camera, side] :
         {std::pair{over, WaterSide::above}, {under, WaterSide::below}, {across, WaterSide::crossing}}) {
        const Widened w = widened(camera, 30);
        const Image wide = renderer.linear(w.wide, w.wideSize);
        EXPECT_EQ(renderer.stats.plan.side, side);
        const Image part = renderer.linear(w.part, eyeSize);
        EXPECT_EQ(renderer.stats.plan.side, side);
        EXPECT_LT(differing(partOf(wide, 60, eyeSize.x), part), 0.04) << static_cast<int>(side);
        EXPECT_GT(differing(partOf(wide, 30, eyeSize.x), part), 0.15) << "the test sees no shift";
    }
}

// W, and what is mirrored, of an oblique frustum, by every camera and method.
TEST(Stereo, EveryMethodFindsTheBedThroughAnObliqueFrustum)
{
    using Mode = RefractionOptions::CameraMode;
    Scene scene = flatLake(2.0f, 20.0f);
    scene.meshes.clear(), scene.elements.clear(), scene.primitives.clear();
    addFloor(scene, -2.0f, 20.0f, 0, 80);
    Camera camera = overTheLake();
    camera.lensShift = 0.4f;
    const glm::dmat4 worldFromClip =
        glm::inverse(glm::dmat4(clipFromView(camera, 4.0f / 3.0f)) * glm::dmat4(viewFromWorld(camera)));
    Options options = plain();
    options.refraction.steps = 8;
    TestRenderer test(scene, options);
    for (const Mode mode : {Mode::main, Mode::snell, Mode::flat})
        for (const WaterOptions::Grid grid : {WaterOptions::Grid::uniform, WaterOptions::Grid::focused}) {
            options.refraction.camera = mode;
            options.water.grid = grid;
            test.renderer.setOptions(options, scene.water);
            const WaterQuantities used = readQuantities(test.renderer, camera, 0.0, eyeSize);
            std::vector<double> offSurface, offBed, offMirror;
            for (int y = 0; y < eyeSize.y; ++y) {
                for (int x = 0; x < eyeSize.x; ++x) {
                    const auto i = static_cast<std::size_t>(y * eyeSize.x + x);
                    if (!used.isWater[i]) continue;
                    const glm::dvec4 far = worldFromClip * glm::dvec4(2.0 * (x + 0.5) / eyeSize.x - 1.0,
                                                                      1.0 - 2.0 * (y + 0.5) / eyeSize.y, 1.0, 1.0);
                    const dvec3 ray = glm::normalize(dvec3(far) / far.w - dvec3(camera.eye)), up(0.0, 1.0, 0.0);
                    const dvec3 surface = dvec3(camera.eye) - ray * (static_cast<double>(camera.eye.y) / ray.y);
                    const dvec3 bent = optics64::refractRay(ray, up, 1.0 / 1.33);
                    const dvec3 bed = surface + bent * (2.0 / -bent.y);
                    offSurface.push_back(glm::distance(surface, dvec3(used.surface[i])));
                    if (std::max(std::abs(bed.x), std::abs(bed.z)) < 9.5)
                        offBed.push_back(std::max(glm::distance(bed, dvec3(used.position[i])),
                                                  glm::distance(bed, dvec3(used.picture[i]))));
                    if (used.mirrorsSky[i])
                        offMirror.push_back(glm::distance(optics64::reflectRay(ray, up), dvec3(used.mirrored[i])));
                }
            }
            ASSERT_GT(offBed.size(), 1000u);
            ASSERT_GT(offMirror.size(), 1000u);
            const auto at = [](std::vector<double>& values, double fraction) {
                std::sort(values.begin(), values.end());
                return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
            };
            const int which = static_cast<int>(mode);
            EXPECT_LT(at(offSurface, 1.0), 1e-2) << which;
            EXPECT_LT(at(offBed, 0.5), 0.01) << which;
            EXPECT_LT(at(offBed, 0.95), 0.05) << which;
            EXPECT_LT(at(offMirror, 0.95), 0.01) << which;
        }
}

TEST(Stereo, SideBySideAreTheTwoEyesPictures)
{
    const Scene scene = livelyLake();
    Options one = plain();
    one.caustics.extent = 100.0f; // all of the water: else a part about the middle between the eyes, or about one
    const Options options = stereoOf(one, StereoOptions::Output::sideBySide);
    TestRenderer test(scene, options);
    const Camera head = overTheLake();
    for (const DebugView view : {DebugView::final, DebugView::positionA, DebugView::normals}) {
        test.renderer.setOptions(options, scene.water);
        test.renderer.render({head, 0.7, eyeSize, view});
        const Image linear = test.renderer.readLinear(), shown = test.renderer.readDisplay();
        ASSERT_EQ(ivec2(linear.width, linear.height), ivec2(2 * eyeSize.x, eyeSize.y));
        ASSERT_EQ(ivec2(shown.width, shown.height), ivec2(2 * eyeSize.x, eyeSize.y));
        test.renderer.setOptions(one, scene.water);
        for (const Eye eye : bothEyes) {
            const int from = eye == Eye::left ? 0 : eyeSize.x;
            test.renderer.render({eyeCamera(head, options.stereo, eye), 0.7, eyeSize, view});
            EXPECT_EQ(partOf(linear, from, eyeSize.x).floats, test.renderer.readLinear().floats) << eyeName(eye);
            EXPECT_EQ(partOf(shown, from, eyeSize.x).bytes, test.renderer.readDisplay().bytes) << eyeName(eye);
        }
        EXPECT_NE(partOf(shown, 0, eyeSize.x).bytes, partOf(shown, eyeSize.x, eyeSize.x).bytes);
    }
}

TEST(Stereo, EyesThatAreNotApartSeeWhatOneDoesBitForBit)
{
    const Scene scene = livelyLake();
    for (Options one : {Options{}, plain()}) {
        if (one.frame.msaa > 1) one.frame.scale = 2.0f;
        TestRenderer test(scene, one);
        const Camera head = overTheLake();
        test.renderer.render({head, 0.7, eyeSize});
        const Image linear = test.renderer.readLinear(), shown = test.renderer.readDisplay();
        test.renderer.setOptions(stereoOf(one, StereoOptions::Output::sideBySide, 0.0f), scene.water);
        test.renderer.render({head, 0.7, eyeSize});
        const Image both = test.renderer.readLinear(), bothShown = test.renderer.readDisplay();
        for (const int from : {0, eyeSize.x}) {
            EXPECT_EQ(partOf(both, from, eyeSize.x).floats, linear.floats);
            EXPECT_EQ(partOf(bothShown, from, eyeSize.x).bytes, shown.bytes);
        }
    }
}

TEST(Stereo, AnAnaglyphIsMadeOfWhatIsShown)
{
    const Scene scene = livelyLake();
    const Options options = stereoOf(plain(), StereoOptions::Output::sideBySide);
    TestRenderer test(scene, options);
    test.renderer.render({overTheLake(), 0.7, eyeSize});
    const Image beside = test.renderer.readDisplay();
    test.renderer.setOptions(stereoOf(plain(), StereoOptions::Output::anaglyph), scene.water);
    test.renderer.render({overTheLake(), 0.7, eyeSize});
    const Image anaglyph = test.renderer.readDisplay();
    ASSERT_EQ(ivec2(anaglyph.width, anaglyph.height), eyeSize);
    const Image left = partOf(beside, 0, eyeSize.x), right = partOf(beside, eyeSize.x, eyeSize.x);
    const auto light = [](const Image& image, std::size_t pixel) {
        vec3 value;
        for (std::size_t c = 0; c < 3; ++c)
            value[static_cast<int>(c)] = static_cast<float>(image.bytes[3 * pixel + c]) / 255.0f;
        return optics::linearColour(value);
    };
    for (std::size_t i = 0; i < anaglyph.bytes.size() / 3; ++i) {
        const vec3 expected = 255.0f * optics::srgbColour(optics::anaglyphRedCyan(light(left, i), light(right, i)));
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(static_cast<float>(anaglyph.bytes[3 * i + c]), expected[static_cast<int>(c)], 1.0f) << i;
    }
    EXPECT_THROW(test.renderer.readLinear(), Error);
}

// Sun maps and caustics do not depend on the eye.
TEST(Stereo, SunlightAndCausticsAreDrawnOnce)
{
    const Scene scene = livelyLake();
    const auto drawCalls = [&](Options options, const char* pass) {
        options.plan.rules[static_cast<std::size_t>(RuleId::cullChunks)] = false; // each eye sees other parts
        TestRenderer test(scene, options);
        FrameReport stats = test.renderer.render({overTheLake(), 0.0, eyeSize});
        EXPECT_EQ(std::count_if(stats.passes.begin(), stats.passes.end(),
                                [&](const FrameReport::Pass& p) { return p.name == pass; }),
                  1);
        return stats.of(pass).drawCalls;
    };
    const Options two = stereoOf(plain(), StereoOptions::Output::sideBySide);
    for (const char* pass : {"sunlight", "caustics"}) EXPECT_EQ(drawCalls(two, pass), drawCalls(plain(), pass)) << pass;
    for (const char* pass : {"refraction", "water"})
        EXPECT_EQ(drawCalls(two, pass), 2 * drawCalls(plain(), pass)) << pass;
}

// Straight down through still water the drawn pair's disparity is that of the apparent depth h + d / n.
TEST(Stereo, TheDrawnBedIsAtItsApparentDepth)
{
    const double height = 2.0, depth = 3.0, apparent = height + depth / 1.33;
    const Scene scene = flatLake(static_cast<float>(depth), 40.0f);
    Camera head;
    head.eye = {0.0f, static_cast<float>(height), 0.0f};
    head.target = vec3(0.0f);
    head.up = {0.0f, 0.0f, -1.0f};
    head.verticalFov = glm::radians(8.0f);
    const double perTangent = 0.5 * eyeSize.y / std::tan(glm::radians(4.0));
    TestRenderer test(scene, plain());
    StereoOptions stereo;
    for (const double convergence : {2.0, apparent, 50.0}) {
        stereo.convergence = static_cast<float>(convergence);
        const auto points = [&](Eye eye) {
            const Camera camera = eyeCamera(head, stereo, eye);
            return pointsShown(readQuantities(test.renderer, camera, 0.0, eyeSize), camera, ShownBy::refraction);
        };
        const auto found = disparities({points(Eye::left), points(Eye::right)}, scene.water, ShownBy::refraction);
        const auto& middle = found[static_cast<std::size_t>(eyeSize.y / 2 * eyeSize.x + eyeSize.x / 2)];
        ASSERT_TRUE(middle);
        EXPECT_NEAR(middle->x, perTangent * 0.065 * (1.0 / convergence - 1.0 / apparent), 0.05) << convergence;
        EXPECT_NEAR(middle->y, 0.0, 0.05) << convergence;
    }
}

TEST(Stereo, QuantitiesAreOfOneEye)
{
    const Scene scene = flatLake(2.0f);
    TestRenderer test(scene, stereoOf(plain(), StereoOptions::Output::pair));
    EXPECT_THROW(readQuantities(test.renderer, overTheLake(), 0.0, eyeSize), Error);
}

} // namespace tarn::test

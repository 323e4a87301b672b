// What an eye under water sees, and an eye that goes through the surface.
#include "gl_test.h"
#include "test_renderer.h"
#include "test_scenes.h"

#include "optics/optics.h"
#include "optics/waves.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tarn::test {

namespace {

using glm::dvec3;

constexpr double n = 1.33;

/// A camera under water, looking so many degrees off the vertical, towards -z.
Camera lookUp(double degreesFromVertical, float depth, float degreesOfView = 110.0f)
{
    const auto angle = static_cast<float>(glm::radians(degreesFromVertical));
    Camera camera;
    camera.eye = vec3(0.0f, -depth, 0.0f);
    camera.target = camera.eye + vec3(0.0f, std::cos(angle), -std::sin(angle));
    camera.up = vec3(0.0f, std::sin(angle), std::cos(angle));
    camera.verticalFov = glm::radians(degreesOfView);
    camera.farPlane = 500.0f;
    return camera;
}

/// The pixels' rays, double precision; y counts from the top.
class Rays {
public:
    Rays(const Camera& camera, ivec2 size)
        : size_(size), eye_(camera.eye), worldFromView_(glm::inverse(glm::dmat4(viewFromWorld(camera)))),
          up_(std::tan(0.5 * static_cast<double>(camera.verticalFov)))
    {}
    /// From the eye, 1 long along the camera's axis, so that times the near plane's distance it ends on that plane.
    dvec3 through(double x, double y) const
    {
        const double aspect = static_cast<double>(size_.x) / size_.y;
        return glm::dmat3(worldFromView_) *
               dvec3((2.0 * (x + 0.5) / size_.x - 1.0) * aspect * up_, (1.0 - 2.0 * (y + 0.5) / size_.y) * up_, -1.0);
    }
    const dvec3& eye() const { return eye_; }

private:
    ivec2 size_;
    dvec3 eye_;
    glm::dmat4 worldFromView_;
    double up_;
};

Options plain()
{
    Options options;
    options.frame.msaa = 1;
    options.glow.enabled = false;
    return options;
}

/// A still lake whose bed glows and reflects nothing.
Scene glowingLake(float depth, const vec3& bed, float edge = 400.0f)
{
    Scene scene = flatLake(depth, edge);
    scene.materials[0].diffuse = vec3(0.0f);
    scene.materials[0].emissive = bed;
    return scene;
}

constexpr ivec2 pictureSize(320, 240);

} // namespace

// A black bed under a white sky: the window is a disc of 48.75° about the zenith, and nothing is outside.
TEST(Underwater, SnellsWindow)
{
    const Scene scene = glowingLake(10.0f, vec3(0.0f));
    const Camera camera = lookUp(0.0, 1.0f);
    CheckedRenderer renderer(scene, plain());
    const Image image = renderer.linear(camera, pictureSize);
    EXPECT_TRUE(renderer.stats.plan.underwater);
    const double critical = std::tan(std::asin(1.0 / n));
    EXPECT_NEAR(glm::degrees(std::atan(critical)), 48.75, 0.01);
    const double pixelsPerTangent = 0.5 * pictureSize.y / std::tan(0.5 * static_cast<double>(camera.verticalFov));
    const Rays rays(camera, pictureSize);
    int inside = 0;
    for (int y = 0; y < pictureSize.y; ++y) {
        for (int x = 0; x < pictureSize.x; ++x) {
            const dvec3 ray = rays.through(x, y);
            const double tangent = std::hypot(ray.x, ray.z) / ray.y;
            const double cosine = glm::normalize(ray).y;
            const double past = (tangent - critical) * pixelsPerTangent;
            const float value = pixel(image, x, y).y;
            if (past > 1.0) {
                EXPECT_EQ(value, 0.0f) << x << ", " << y;
            } else if (past < -1.0) {
                ++inside;
                const double expected = n * n * (1.0 - optics64::fresnelExact(cosine, n));
                EXPECT_NEAR(value, expected, 0.005 * expected + 1.0e-3) << x << ", " << y;
            }
        }
    }
    EXPECT_NEAR(inside, std::numbers::pi * std::pow(critical * pixelsPerTangent, 2.0), 0.03 * inside);
}

// Outside of the window the bed, mirrored, and absorbed along both legs; inside it the sky along the one.
TEST(Underwater, EveryLegIsAbsorbed)
{
    const vec3 bed(0.9f, 0.5f, 0.2f);
    Scene scene = glowingLake(4.0f, bed);
    scene.water.absorption = vec3(0.2f, 0.1f, 0.02f);
    const float depth = 1.0f;
    const Camera camera = lookUp(30.0, depth, 90.0f);
    CheckedRenderer renderer(scene, plain());
    const Image image = renderer.linear(camera, pictureSize);
    const Rays rays(camera, pictureSize);
    int outside = 0;
    for (int y = 0; y < pictureSize.y; ++y) {
        for (int x = 0; x < pictureSize.x; ++x) {
            const dvec3 ray = glm::normalize(rays.through(x, y));
            if (ray.y < 0.1) continue; // to the bed itself, and grazing
            const double f = optics64::fresnelExact(ray.y, n);
            if (f < 1.0 && f > 0.5) continue; // the window's edge
            if (f == 1.0) ++outside;
            for (int c = 0; c < 3; ++c) {
                const double k = static_cast<double>(scene.water.absorption[c]);
                const double mirrored = static_cast<double>(bed[c]) * std::exp(-k * (depth + 4.0) / ray.y);
                const double expected = f * mirrored + (1.0 - f) * n * n * std::exp(-k * depth / ray.y);
                ASSERT_NEAR(pixel(image, x, y)[c], expected, 0.01 * expected + 1.0e-4) << x << ", " << y;
            }
        }
    }
    EXPECT_GT(outside, pictureSize.x * pictureSize.y / 4);
}

// As published there is no window: every pixel mixes the sky and the mirrored bed by Schlick.
TEST(Underwater, ThePaperHasNoTotalReflection)
{
    const vec3 bed(0.1f, 0.2f, 0.3f);
    const Scene scene = glowingLake(4.0f, bed);
    const Camera camera = lookUp(0.0, 1.0f, 100.0f);
    Options options = plain();
    options.underwater.refraction = UnderwaterOptions::Refraction::paper;
    CheckedRenderer renderer(scene, options);
    const Image image = renderer.linear(camera, pictureSize);
    const Image hits = renderer.linear(camera, pictureSize, 0.0, DebugView::positionW);
    const Rays rays(camera, pictureSize);
    for (int y = 0; y < pictureSize.y; ++y) {
        for (int x = 0; x < pictureSize.x; ++x) {
            const dvec3 ray = glm::normalize(rays.through(x, y));
            const double f = optics64::fresnelSchlick(ray.y, n, 5.0);
            for (int c = 0; c < 3; ++c) {
                const double expected = f * static_cast<double>(bed[c]) + (1.0 - f) * n * n;
                ASSERT_NEAR(pixel(image, x, y)[c], expected, 0.005 * expected) << x << ", " << y;
            }
            // W1 = U + m R1, m = 1.5 (eqs. 12 and 13).
            const dvec3 surface = rays.eye() + ray / ray.y;
            const dvec3 hit = surface + 1.5 * optics64::refractRayOfPaper(-ray, dvec3(0, 1, 0), n);
            ASSERT_LT(glm::distance(hit, dvec3(pixel(hits, x, y))), 2.0e-3) << x << ", " << y;
        }
    }
}

// A ceiling over the water: the iterative intersection finds it where Snell's ray meets it.
TEST(Underwater, WhatStandsOverTheWaterIsFoundAlongSnellsRay)
{
    Scene scene = glowingLake(4.0f, vec3(0.0f));
    const double ceiling = 3.0;
    addBox(scene, {-40.0f, static_cast<float>(ceiling), -40.0f}, {40.0f, 5.0f, 40.0f}, 0);
    const Camera camera = lookUp(15.0, 1.5f, 60.0f);
    Options options = plain();
    options.refraction.steps = 8;
    CheckedRenderer renderer(scene, options);
    const Image hits = renderer.linear(camera, pictureSize, 0.0, DebugView::positionW);
    const Rays rays(camera, pictureSize);
    int found = 0;
    double worst = 0.0;
    for (int y = 0; y < pictureSize.y; ++y) {
        for (int x = 0; x < pictureSize.x; ++x) {
            const dvec3 ray = glm::normalize(rays.through(x, y));
            if (std::sqrt(1.0 - ray.y * ray.y) > 0.4) continue; // leaves the target
            const dvec3 refracted = optics64::refractRay(ray, dvec3(0, -1, 0), n);
            const dvec3 hit = rays.eye() + ray * (1.5 / ray.y) + refracted * (ceiling / refracted.y);
            worst = std::max(worst, glm::distance(hit, dvec3(pixel(hits, x, y))));
            ++found;
        }
    }
    EXPECT_GT(found, pictureSize.x * pictureSize.y / 4);
    EXPECT_LT(worst, 0.02);
}

namespace {

constexpr ivec2 sweepSize(160, 120);
constexpr int sweepSteps = 101;

/// Moving water over a green bed, under a blue sky; the deep is red. So blue has come through the surface, and green
/// through water.
Scene sweepScene()
{
    Scene scene = glowingLake(2.0f, vec3(0.0f, 1.0f, 0.0f), 24.0f);
    scene.sky.radiance = vec3(0.2f, 0.0f, 1.0f);
    scene.water.absorption = vec3(0.5f);
    scene.water.colour = vec3(0.3f, 0.0f, 0.0f);
    scene.water.waves = {{0.05f, 3.0f, 0.4f, 0.0f, 0.0f}, {0.03f, 1.6f, 1.4f, 1.0f, 0.0f}};
    return scene;
}

Camera sweepCamera(int step, float fall)
{
    Camera camera;
    camera.eye = vec3(0.3f, 0.5f - 0.01f * static_cast<float>(step), 0.2f);
    camera.target = camera.eye + vec3(0.2f, -fall, -1.0f);
    camera.verticalFov = glm::radians(60.0f);
    return camera;
}

double sweepTime(int step) { return 3.0 + step / 60.0; }

/// The drawn surface, its vertices worked out once.
class DrawnMesh {
public:
    DrawnMesh(const WaterBody& water, int size, double time)
        : cells_(size - 1), half_(0.5 * static_cast<double>(water.extent.x))
    {
        for (int z = 0; z < size; ++z)
            for (int x = 0; x < size; ++x) heights_.push_back(surfaceHeight(water, vec2(at(x), at(z)), time));
    }
    bool holds(const dvec3& p) const { return std::abs(p.x) <= half_ && std::abs(p.z) <= half_; }
    double height(const dvec3& p) const
    {
        const double x = (p.x + half_) / (2.0 * half_) * cells_;
        const double z = (p.z + half_) / (2.0 * half_) * cells_;
        const int i = std::clamp(static_cast<int>(x), 0, cells_ - 1);
        const int j = std::clamp(static_cast<int>(z), 0, cells_ - 1);
        const double u = x - i;
        const double v = z - j;
        if (u + v <= 1.0) return vertex(i, j) * (1.0 - u - v) + vertex(i + 1, j) * u + vertex(i, j + 1) * v;
        return vertex(i + 1, j + 1) * (u + v - 1.0) + vertex(i, j + 1) * (1.0 - u) + vertex(i + 1, j) * (1.0 - v);
    }
    double over(const dvec3& p) const { return p.y - height(p); }

    /// Where a ray that begins at `from` first goes through the surface, in units of `ray`; infinite if nowhere.
    double meets(const dvec3& from, const dvec3& ray) const
    {
        constexpr double nowhere = std::numeric_limits<double>::infinity();
        if (!holds(from)) return nowhere;
        const bool began = over(from) < 0.0;
        double last = 0.0;
        for (double t = 0.002; t < 40.0; t += 0.002 + 0.004 * t) {
            const dvec3 p = from + ray * t;
            if (!holds(p) || std::abs(p.y) > 2.0) return nowhere;
            if ((over(p) < 0.0) != began) {
                double near = last;
                double far = t;
                for (int i = 0; i < 40; ++i) {
                    const double middle = 0.5 * (near + far);
                    ((over(from + ray * middle) < 0.0) == began ? near : far) = middle;
                }
                return 0.5 * (near + far);
            }
            last = t;
        }
        return nowhere;
    }

private:
    float at(int i) const { return static_cast<float>(half_ * (2.0 * i / cells_ - 1.0)); }
    double vertex(int x, int z) const
    {
        return static_cast<double>(heights_[static_cast<std::size_t>(z * (cells_ + 1) + x)]);
    }

    int cells_;
    double half_;
    std::vector<float> heights_;
};

double luminance(const vec3& c) { return glm::dot(glm::dvec3(c), glm::dvec3(0.2126, 0.7152, 0.0722)); }

double meanLuminance(const Image& image)
{
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) sum += luminance(vec3(pixel(image, x, y)));
    return sum / (image.width * image.height);
}

} // namespace

// The triangle of the plan and of the mask is the one that the grid draws.
TEST(Sweep, TheDrawnSurfaceIsTheMeshs)
{
    const Scene scene = sweepScene();
    const DrawnMesh mesh(scene.water, 49, 3.0);
    const optics64::WaterGrid grid = optics64::uniformGrid({0.0, 0.0, 12.0, 12.0}, 49);
    for (int i = 0; i < 2000; ++i) {
        const vec2 at(-11.9f + 0.0119f * static_cast<float>(i), 11.0f - 0.0087f * static_cast<float>(i));
        EXPECT_NEAR(drawnHeight(scene.water, grid, at, 3.0), mesh.height(dvec3(at.x, 0.0, at.y)), 2.0e-6);
    }
}

class SweepThrough : public testing::TestWithParam<float> {};

// From half a metre above to half a metre below: every pixel is what its side of the drawn surface shows.
TEST_P(SweepThrough, EveryPixelIsOfItsSide)
{
    const Scene scene = sweepScene();
    Options options = plain();
    options.water.filterWaves = false;
    options.water.surfaceSteps = 0; // the colours below are those of the triangles' points
    CheckedRenderer renderer(scene, options);
    options.underwater.enabled = false;
    CheckedRenderer air(scene, options); // all of it as from above

    std::vector<optics64::WaveTerm> terms;
    for (const Wave& w : scene.water.waves)
        terms.push_back(optics64::makeWaveTerm(static_cast<double>(w.amplitude), static_cast<double>(w.wavelength),
                                               static_cast<double>(w.direction), static_cast<double>(w.phase)));

    int crossings = 0;
    int neither = 0;
    int wrongSide = 0;
    int underPixels = 0;
    for (int step = 0; step < sweepSteps; ++step) {
        const Camera camera = sweepCamera(step, GetParam());
        const double time = sweepTime(step);
        const Image image = renderer.linear(camera, sweepSize, time);
        const WaterSide side = renderer.stats.plan.side;
        if (side == WaterSide::crossing) ++crossings;
        const Image fromAbove = air.linear(camera, sweepSize, time);
        const DrawnMesh mesh(scene.water, options.water.gridSize, time);
        const Rays rays(camera, sweepSize);
        const int stride = side == WaterSide::crossing ? 1 : 3;
        for (int y = 0; y < sweepSize.y; y += stride) {
            for (int x = 0; x < sweepSize.x; x += stride) {
                const dvec3 ray = rays.through(x, y);
                const dvec3 from = rays.eye() + ray * static_cast<double>(camera.nearPlane);
                const vec3 value(pixel(image, x, y));
                const bool isUnder = mesh.over(from) < 0.0;
                const bool looksAbove = glm::distance(value, vec3(pixel(fromAbove, x, y))) < 1.0e-3f;
                if (isUnder) ++underPixels;
                if (!isUnder && looksAbove) continue;

                // Under water, blue comes through the surface or not at all, and green from the bed.
                const dvec3 unit = glm::normalize(ray);
                const double meets = mesh.meets(from, ray);
                double blue = 0.0;
                double green = 0.0;
                bool knowsGreen = true;
                if (std::isfinite(meets)) {
                    const dvec3 u = from + ray * meets;
                    // Of the waves, not of the facet: normals are per pixel.
                    const dvec3 normal = optics64::waveNormalAt(terms, {u.x, u.z}, time);
                    const double f = optics64::fresnelExact(dot(unit, normal), n);
                    blue = (1.0 - f) * n * n * std::exp(-0.5 * glm::distance(u, rays.eye()));
                    knowsGreen = false;
                } else if (unit.y < 0.0) {
                    const dvec3 bed = rays.eye() + unit * ((-2.0 - rays.eye().y) / unit.y);
                    if (mesh.holds(bed)) green = std::exp(-0.5 * glm::distance(bed, rays.eye()));
                }
                const bool looksUnder = std::abs(blue - static_cast<double>(value.z)) < 0.01 + 0.03 * blue &&
                                        (!knowsGreen || std::abs(green - static_cast<double>(value.y)) < 0.01);
                if (!looksAbove && !looksUnder) {
                    if (++neither <= 10)
                        ADD_FAILURE() << "step " << step << " pixel " << x << ", " << y
                                      << " is of neither side: " << value.x << " " << value.y << " " << value.z
                                      << ", under " << isUnder << ", meets " << meets << ", blue " << blue << ", green "
                                      << green;
                }
                // The line itself may fall to either.
                const dvec3 below = rays.eye() + rays.through(x, y + 1) * static_cast<double>(camera.nearPlane);
                const double halfPixel = std::abs(mesh.over(below) - mesh.over(from));
                if (std::abs(mesh.over(from)) > halfPixel && !(isUnder ? looksUnder : looksAbove)) {
                    if (++wrongSide <= 10)
                        ADD_FAILURE() << "step " << step << " pixel " << x << ", " << y
                                      << " is of the wrong side: " << value.x << " " << value.y << " " << value.z
                                      << ", under " << isUnder << ", meets " << meets << ", blue " << blue << ", green "
                                      << green << ", height " << mesh.over(from);
                }
            }
        }
    }
    EXPECT_EQ(neither, 0);
    EXPECT_EQ(wrongSide, 0);
    EXPECT_GT(crossings, 3);
    EXPECT_LT(crossings, 60);
    EXPECT_GT(underPixels, 1000);
}

// The same in the default quality: what changes, changes from step to step, and nothing lights up for one of them.
TEST_P(SweepThrough, NothingFlashes)
{
    const Scene scene = sweepScene();
    CheckedRenderer renderer(scene, {});
    std::vector<double> means;
    for (int step = 0; step < sweepSteps; ++step)
        means.push_back(meanLuminance(renderer.linear(sweepCamera(step, GetParam()), sweepSize, sweepTime(step))));
    const auto [least, most] = std::minmax_element(means.begin(), means.end());
    double largest = 0.0;
    double spike = 0.0;
    for (std::size_t i = 1; i < means.size(); ++i) {
        largest = std::max(largest, std::abs(means[i] - means[i - 1]));
        if (i < 2 || i + 2 >= means.size()) continue;
        // The bottom of a valley lies under its neighbours, but not under where they lead.
        const auto [low, high] = std::minmax(
            {means[i - 1], means[i + 1], 2.0 * means[i - 1] - means[i - 2], 2.0 * means[i + 1] - means[i + 2]});
        spike = std::max(spike, std::abs(means[i] - std::clamp(means[i], low, high)));
    }
    // A step of 1 cm moves the line over a twelfth of the near plane; measured: 0.13 at most.
    EXPECT_LT(largest, 0.16 * *most);
    EXPECT_LT(spike, 0.01 * *most) << spike / *most;
    EXPECT_GT(*least, 0.1 * *most);
}

// Several samples a pixel: on the line none may show the bed as if the water were not there, nor the bare background.
TEST_P(SweepThrough, NoSampleOnTheLineIsBare)
{
    const Scene scene = sweepScene();
    Options options = plain();
    CheckedRenderer single(scene, options);
    options.frame.msaa = 4;
    CheckedRenderer several(scene, options);
    for (int step = 35; step <= 65; ++step) {
        const Image one = single.linear(sweepCamera(step, GetParam()), sweepSize, sweepTime(step));
        if (single.stats.plan.side != WaterSide::crossing) continue;
        const Image four = several.linear(sweepCamera(step, GetParam()), sweepSize, sweepTime(step));
        float mostGreen = 0.0f;
        float leastRed = 1.0f;
        for (int y = 0; y < sweepSize.y; ++y) {
            for (int x = 0; x < sweepSize.x; ++x) {
                mostGreen = std::max(mostGreen, pixel(one, x, y).y);
                leastRed = std::min(leastRed, pixel(one, x, y).x);
            }
        }
        int bare = 0;
        for (int y = 0; y < sweepSize.y; ++y)
            for (int x = 0; x < sweepSize.x; ++x)
                if (pixel(four, x, y).y > mostGreen + 0.01f || pixel(four, x, y).x < 0.9f * leastRed) ++bare;
        EXPECT_EQ(bare, 0) << "step " << step;
    }
}

INSTANTIATE_TEST_SUITE_P(Views, SweepThrough, testing::Values(0.0f, 0.4f, -0.4f), [](const auto& test) {
    return test.param == 0.0f ? "along" : test.param > 0.0f ? "down" : "up";
});

} // namespace tarn::test

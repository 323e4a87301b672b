// The search for the bed (Mihálik 2008, section 7.1) against exact intersections, over beds that are
// functions.
//
// No GPU and no picture: the "depth picture" is the exact first hit of the ray through W, or that of the
// centre of its texel where texels are asked for.

#include "optics/refraction_camera.h"
#include "optics/waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

namespace tarn {
namespace {

using glm::dvec2;
using glm::dvec3;
using HeightField = std::function<double(dvec2)>;

constexpr double n = 1.33;
constexpr double degree = std::numbers::pi / 180.0;

/// Where a ray first crosses a height field, by steps of centimetres and bisection.
std::optional<double> crossing(const HeightField& height, dvec3 origin, dvec3 direction, double longest)
{
    auto over = [&](double s) {
        const dvec3 p = origin + s * direction;
        return p.y - height({p.x, p.z});
    };
    const bool startsOver = over(0.0) >= 0.0;
    double before = 0.0;
    while (before < longest) {
        double after = before + 0.03 * (1.0 + 0.02 * before);
        if ((over(after) >= 0.0) == startsOver) {
            before = after;
            continue;
        }
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (before + after);
            ((over(middle) >= 0.0) == startsOver ? before : after) = middle;
        }
        return 0.5 * (before + after);
    }
    return std::nullopt;
}

/// The refraction camera: an eye, axes, and a square picture of `texels` with these tangents.
struct Viewer {
    dvec3 eye, right, up, forward;
    double tangent = 1.0;
    int texels = 512;

    dvec3 directionV(dvec3 v) const { return {glm::dot(v, right), glm::dot(v, up), -glm::dot(v, forward)}; }
    dvec3 directionW(dvec3 v) const { return v.x * right + v.y * up - v.z * forward; }
    dvec3 pointV(dvec3 p) const { return directionV(p - eye); }
    dvec2 texel(dvec3 v) const { return dvec2(v.x, v.y) / (-v.z * tangent) * (0.5 * texels); }
    dvec3 throughTexel(dvec2 t) const { return {t * tangent / (0.5 * texels), -1.0}; }
};

struct Lake {
    HeightField bed;
    std::vector<optics64::WaveTerm> waves;
    double incidence = 45.0; ///< degrees, of the picture's centre
    bool turnedCamera = true;
    bool wholeTexels = false; ///< depth of the texel's centre, as a nearest lookup gives it
    double fov = 40.0;        ///< degrees
};

struct Errors {
    std::vector<double> metres, texels; ///< of each pixel, sorted
    double metresAt(double fraction) const
    {
        return metres.at(static_cast<std::size_t>(fraction * double(metres.size() - 1)));
    }
    double texelsAt(double fraction) const
    {
        return texels.at(static_cast<std::size_t>(fraction * double(texels.size() - 1)));
    }
    double fractionOver(double limit) const
    {
        return double(metres.end() - std::upper_bound(metres.begin(), metres.end(), limit)) / double(metres.size());
    }
};

Viewer refractionViewer(const Lake& lake, const Viewer& main)
{
    Viewer viewer = main;
    const double height = main.eye.y;
    viewer.tangent = main.tangent * double(optics::fovExtension(float(height), 1.5f, 1.2f));
    if (lake.turnedCamera) {
        const auto turned = optics::refractionCamera(vec3(main.eye), vec3(main.forward), vec3(main.up),
                                                     float(lake.fov * degree), 0.0f, float(n));
        viewer.eye = dvec3(turned.eye);
        viewer.forward = glm::normalize(dvec3(turned.forward));
        viewer.right = glm::normalize(glm::cross(viewer.forward, dvec3(turned.up)));
        viewer.up = glm::cross(viewer.right, viewer.forward);
    }
    return viewer;
}

/// One error per pixel after `depthSamples` samples of the depth; 0: the planar approximation.
Errors run(const Lake& lake, int depthSamples, bool takesLast = false)
{
    const double a = lake.incidence * degree;
    Viewer main;
    // Eight metres from the water at the centre, at least a metre above it.
    main.eye = dvec3(0.0, std::cos(a), std::sin(a)) * std::max(8.0, 1.0 / std::max(std::cos(a), 0.01));
    main.forward = dvec3(0.0, -std::cos(a), -std::sin(a));
    main.right = dvec3(1.0, 0.0, 0.0);
    main.up = glm::cross(main.right, main.forward);
    main.tangent = std::tan(0.5 * lake.fov * degree);
    const Viewer viewer = refractionViewer(lake, main);
    const HeightField surface = [&](dvec2 x) { return optics64::waveHeight(lake.waves, x, 0.0); };

    Errors errors;
    const int side = 24;
    for (int pixel = 0; pixel < side * side; ++pixel) {
        const dvec2 screen = (dvec2(pixel % side, pixel / side) + 0.5) * (2.0 / side) - 1.0;
        const dvec3 ray = glm::normalize(main.directionW({screen * main.tangent, -1.0}));
        const auto toWater = crossing(surface, main.eye, ray, 60.0);
        if (!toWater) continue;
        const dvec3 point = main.eye + *toWater * ray;
        const dvec3 normal = optics64::waveNormalAt(lake.waves, {point.x, point.z}, 0.0);
        if (glm::dot(normal, ray) > -0.01) continue; // the wave's back
        const dvec3 refracted = optics64::refractRay(ray, normal, 1.0 / n);
        const auto toBed = crossing(lake.bed, point + 1e-6 * refracted, refracted, 60.0);
        if (!toBed) continue;
        const dvec3 truth = viewer.pointV(point + (*toBed + 1e-6) * refracted);

        auto depth = [&](dvec3 w) {
            if (lake.wholeTexels) w = viewer.throughTexel(glm::floor(viewer.texel(w)) + 0.5);
            const dvec3 direction = viewer.directionW(glm::normalize(w));
            const double farPlane = 300.0;
            const double s = crossing(lake.bed, viewer.eye, direction, farPlane).value_or(farPlane);
            return viewer.directionV(direction).z * s;
        };
        const dvec3 u = viewer.pointV(point), r = viewer.directionV(refracted);
        const dvec3 first = optics64::depthSample(u, depth(u));
        dvec3 w = optics64::planarIntersection(u, r, first);
        if (depthSamples > 0) {
            auto state = optics64::intersectionBegin(u, r, first);
            for (int i = 1; i < depthSamples; ++i) state = optics64::intersectionStep(state, depth(state.W));
            if (takesLast) state = optics64::intersectionEnd(state);
            w = state.best;
        }
        errors.metres.push_back(glm::length(w - truth));
        errors.texels.push_back(glm::length(viewer.texel(w) - viewer.texel(truth)));
    }
    std::sort(errors.metres.begin(), errors.metres.end());
    std::sort(errors.texels.begin(), errors.texels.end());
    return errors;
}

std::vector<optics64::WaveTerm> threeWaves()
{
    return {optics64::makeWaveTerm(0.05, 4.0, 0.3, 0.1), optics64::makeWaveTerm(0.03, 2.3, 1.7, 1.0),
            optics64::makeWaveTerm(0.015, 1.1, -0.8, 2.0)};
}

double flat(dvec2) { return -3.0; }
double bowl(dvec2 x) { return -5.0 + glm::dot(x, x) / 60.0; }

/// The bowl with a smooth bump and a wall of one metre in it.
double brokenBowl(dvec2 x)
{
    const double bump = std::max(0.0, 1.0 - glm::dot(x - dvec2(1.0, 2.0), x - dvec2(1.0, 2.0)) / 4.0);
    return bowl(x) + 1.5 * bump + (x.x < -3.0 && x.x > -4.0 ? 1.0 : 0.0);
}

TEST(LineIntersection, SolvesEquation3)
{
    // Two lines that meet at U + 2.5 R, and two that pass each other at distance 1 there.
    const dvec3 u(1.0, 2.0, -3.0), r = glm::normalize(dvec3(0.3, -1.0, -0.4)), q(2.0, 0.5, 1.0);
    const dvec3 meeting = u + 2.5 * r;
    EXPECT_NEAR(optics64::distanceAlongRay(u, r, meeting - 3.0 * q, q), 2.5, 1e-13);
    EXPECT_LT(glm::length(optics64::closestOnRay(u, r, meeting + 7.0 * q, q) - meeting), 1e-13);
    const dvec3 aside = glm::normalize(glm::cross(r, q));
    EXPECT_NEAR(optics64::distanceAlongRay(u, r, meeting + aside - q, q), 2.5, 1e-13);
}

TEST(LineIntersection, ParallelLinesHaveNone)
{
    const vec3 u(1.0f, 2.0f, -3.0f), r = glm::normalize(vec3(0.3f, -1.0f, -0.4f));
    EXPECT_EQ(optics::distanceAlongRay(u, r, u + vec3(1.0f), 17.0f * r), -1.0f);
    EXPECT_EQ(optics::distanceAlongRay(u, r, u + vec3(1.0f), vec3(0.0f)), -1.0f);
    EXPECT_EQ(optics::closestOnRay(u, r, u + vec3(1.0f), 17.0f * r), u);
    // A thousandth of a radian is a crossing, not a parallel.
    const vec3 aside = glm::normalize(glm::cross(r, vec3(0.0f, 0.0f, 1.0f)));
    EXPECT_NEAR(optics::distanceAlongRay(u, r, u + 2.0f * r + 0.001f * aside, r - 0.001f * aside), 3.0f, 0.01f);
}

/// The listing of section 7.1, as printed: RayIntersec(W_i, U, A_{i+1} - A_i, R) gives W_i back.
TEST(LineIntersection, AsPrintedItNeverMoves)
{
    const dvec3 u(0.0, -1.0, -5.0), r = glm::normalize(dvec3(0.0, -1.0, -0.3));
    const dvec3 w = u + 2.0 * r, bed(0.1, -0.2, -1.0);
    const dvec3 c = u - w;
    const double m = glm::dot(glm::cross(c, r), glm::cross(bed, r));
    EXPECT_NEAR(m, 0.0, 1e-15);
}

TEST(IntersectionSearch, BeginsWithThePlanarApproximation)
{
    const dvec3 u(0.2, -1.0, -5.0), r = glm::normalize(dvec3(0.0, -1.0, -0.3));
    const dvec3 a = optics64::depthSample(u, -8.0);
    EXPECT_NEAR(a.z, -8.0, 1e-15);
    EXPECT_LT(glm::length(glm::cross(a, u)), 1e-14); // on the line through the eye and U
    const auto state = optics64::intersectionBegin(u, r, a);
    EXPECT_EQ(state.best, u);
    EXPECT_EQ(state.bestA, a);
    EXPECT_LT(glm::length(state.W - optics64::planarIntersection(u, r, a)), 1e-14);
    EXPECT_NEAR(glm::length(state.W - u), glm::length(a - u), 1e-14);
}

/// A flat bed is found exactly by the first intersection: three samples, whatever the angle, waves or none.
TEST(IntersectionSearch, FlatBedIsExactAfterThreeLooks)
{
    for (bool turned : {false, true})
        for (bool waves : {false, true})
            for (double incidence : {0.1, 15.0, 30.0, 45.0, 60.0, 75.0, 80.0, 85.0}) {
                Lake lake{flat, waves ? threeWaves() : std::vector<optics64::WaveTerm>{}, incidence, turned};
                for (int depthSamples : {3, 4, 8}) {
                    const Errors errors = run(lake, depthSamples);
                    ASSERT_GT(errors.metres.size(), 200u) << incidence;
                    EXPECT_LT(errors.metres.back(), 1e-8) << incidence << ' ' << depthSamples << ' ' << turned << waves;
                }
            }
}

/// With whole texels of 512² and eight samples of the depth the lookup still lands within a texel of Snell's answer.
TEST(IntersectionSearch, FlatBedStaysWithinATexelWhenDepthIsATexels)
{
    for (bool turned : {false, true})
        for (double incidence : {0.1, 30.0, 60.0, 80.0, 85.0}) {
            const Errors errors = run({flat, {}, incidence, turned, true}, 8);
            EXPECT_LT(errors.texels.back(), 1.0) << incidence << ' ' << turned;
            EXPECT_GT(errors.texelsAt(0.5), 1e-6) << "the texels made no difference";
        }
}

/// A smooth bed under waves: each look past the second squares the error, about.
TEST(IntersectionSearch, BowlUnderWavesConvergesFast)
{
    for (bool turned : {false, true})
        for (double incidence : {15.0, 30.0, 60.0, 75.0}) {
            const Lake lake{bowl, threeWaves(), incidence, turned};
            const double planar = run(lake, 0).metresAt(0.5);
            const double after3 = run(lake, 3).metresAt(0.5);
            const double after4 = run(lake, 4).metresAt(0.5);
            const Errors after5 = run(lake, 5);
            EXPECT_LT(planar, 5.0) << incidence;
            EXPECT_GT(planar, 0.05) << incidence;
            EXPECT_LT(after3, 0.1) << incidence;
            EXPECT_LT(after4, 0.001) << incidence;
            EXPECT_LT(after5.metresAt(0.5), 1e-4) << incidence;
            EXPECT_LT(after5.metres.back(), 0.001) << incidence;
            EXPECT_LT(after4, 0.2 * after3) << incidence;
        }
}

/// The proposal after the last look is worth that look on a smooth bed, and does no harm at edges.
TEST(IntersectionSearch, TheLastProposalIsWorthALook)
{
    for (bool turned : {false, true})
        for (double incidence : {15.0, 30.0, 60.0, 75.0}) {
            EXPECT_LT(run({flat, threeWaves(), incidence, turned}, 2, true).metres.back(), 1e-8) << incidence;
            const Lake smooth{bowl, threeWaves(), incidence, turned};
            for (int depthSamples : {2, 3, 4})
                EXPECT_LE(run(smooth, depthSamples, true).metresAt(0.5),
                          1.05 * run(smooth, depthSamples + 1).metresAt(0.5))
                    << incidence << ' ' << depthSamples;
            const Lake broken{brokenBowl, threeWaves(), incidence, turned};
            for (int depthSamples : {2, 3, 4, 8})
                EXPECT_LE(run(broken, depthSamples, true).fractionOver(0.05),
                          run(broken, depthSamples).fractionOver(0.05) + 0.005)
                    << incidence << ' ' << depthSamples;
        }
    // After one look it is the planar approximation.
    const Lake lake{bowl, threeWaves(), 60.0, true};
    EXPECT_NEAR(run(lake, 1, true).metresAt(0.5), run(lake, 0).metresAt(0.5), 1e-12);
}

/// What discontinuities leave: a small tail that steps do not cure, while the median is long since right.
TEST(IntersectionSearch, DiscontinuitiesLeaveATail)
{
    const Lake lake{brokenBowl, threeWaves(), 60.0, true};
    const Errors errors = run(lake, 8);
    EXPECT_LT(errors.metresAt(0.5), 1e-4);
    EXPECT_LT(errors.fractionOver(0.05), 0.03);
    // More samples never make the fraction of wrong hits much worse.
    EXPECT_LE(run(lake, 16).fractionOver(0.05), errors.fractionOver(0.05) + 0.005);
}

/// The W that is kept is the one with the least |A - W| of those looked at.
TEST(IntersectionSearch, KeepsTheBest)
{
    const dvec3 u(0.0, -1.0, -5.0), r = glm::normalize(dvec3(0.0, -1.0, -0.3));
    auto state = optics64::intersectionBegin(u, r, optics64::depthSample(u, -6.0));
    double least = state.bestDistance;
    for (double z : {-9.0, -5.5, -30.0, -5.9, -7.0, -1.0, -6.2}) {
        const dvec3 w = state.W;
        const double gap = glm::length(optics64::depthSample(w, z) - w);
        state = optics64::intersectionStep(state, z);
        least = std::min(least, gap);
        EXPECT_EQ(state.bestDistance, least);
        EXPECT_NEAR(glm::length(state.bestA - state.best), least, 1e-12);
        EXPECT_GE(state.s, state.inFront);
        EXPECT_LE(state.s, state.behind);
    }
}

/// A ray that bends back towards the camera never gets W behind it, whatever the picture says.
TEST(IntersectionSearch, WStaysInFrontOfTheCamera)
{
    const vec3 u(0.0f, -0.5f, -2.0f), r = glm::normalize(vec3(0.0f, -0.4f, 1.0f));
    for (float z : {-0.1f, -2.0f, -50.0f, -1.0e5f}) {
        auto state = optics::intersectionBegin(u, r, optics::depthSample(u, z));
        for (int i = 0; i < 12; ++i) {
            ASSERT_LT(state.W.z, 0.0f) << z << ' ' << i;
            ASSERT_TRUE(std::isfinite(state.W.y));
            state = optics::intersectionStep(state, z);
        }
    }
}

/// Seen exactly from where it goes (p through the eye): every intersection is degenerate, nothing may become
/// NaN.
TEST(IntersectionSearch, RayAlongTheViewDirection)
{
    const vec3 u(0.0f, -1.0f, -3.0f), r = glm::normalize(u);
    auto state = optics::intersectionBegin(u, r, optics::depthSample(u, -7.0f));
    for (int i = 0; i < 8; ++i) state = optics::intersectionStep(state, -7.0f);
    EXPECT_LT(glm::length(state.best - optics::depthSample(u, -7.0f)), 1e-5f);
}

// A tree in front of the sky: the ray passes over it, or through it, and the nearest in angle is right.
TEST(MirrorChoice, TakesTheNearestInAngle)
{
    const dvec3 u(0.0, 0.0, -5.0), up(0.0, 1.0, 0.0);
    const dvec3 tree(0.0, 2.0, -25.0), sky(0.0, 300.0, -1000.0);
    const auto chosen = [&](const dvec3& r) {
        auto choice = optics64::mirrorBegin(u, r, up);
        choice = optics64::mirrorConsider(choice, dvec3(1.0, 0.0, -6.0), tree, false);
        choice = optics64::mirrorConsider(choice, dvec3(2.0, 0.0, -6.0), sky, true);
        return optics64::mirrorChosen(choice).x;
    };
    EXPECT_EQ(chosen(glm::normalize(sky - u)), 2.0) << "|A - W| of the sky is hundreds of metres";
    EXPECT_EQ(chosen(glm::normalize(tree - u)), 1.0);
    EXPECT_EQ(chosen(glm::normalize(tree - u + dvec3(0.0, 0.1, 0.0))), 1.0);
}

// The camera below the level sees the tree's foot, then sky under it: what the ray meets is the tree's back.
TEST(MirrorChoice, TakesNoSkyBelowWhatStandsHigher)
{
    const dvec3 u(0.0, 0.0, -5.0), up(0.0, 1.0, 0.0);
    const dvec3 r = glm::normalize(dvec3(0.0, 1.0, -10.0));
    const dvec3 crown = u + 20.0 * r + dvec3(0.0, 1.5, 0.0), beside = u + 900.0 * r;
    auto choice = optics64::mirrorBegin(u, r, up);
    choice = optics64::mirrorConsider(choice, dvec3(1.0, 0.0, -6.0), crown, false);
    choice = optics64::mirrorConsider(choice, dvec3(2.0, 0.0, -6.0), beside, true);
    EXPECT_LT(choice.leastMiss, choice.leastGeometryMiss);
    EXPECT_EQ(optics64::mirrorChosen(choice).x, 1.0);
    EXPECT_EQ(optics64::mirrorMiss(choice), choice.leastGeometryMiss);
    const auto open = optics64::mirrorConsider(optics64::mirrorBegin(u, r, up), dvec3(2.0, 0.0, -6.0), beside, true);
    EXPECT_EQ(optics64::mirrorMiss(open), open.leastMiss);
}

// A guess beside the hit is as good a start as the plane: the next look ends there.
TEST(Intersection, BeginsAtAGuess)
{
    const dvec3 u(0.2, 0.4, -4.0), r = glm::normalize(dvec3(0.1, -0.5, -0.8));
    const dvec3 onBed(0.0, 0.0, -7.0), normal = glm::normalize(dvec3(0.1, 0.6, 0.8)); // a sloping bed
    const auto seen = [&](const dvec3& w) { return w * (glm::dot(onBed, normal) / glm::dot(w, normal)); };
    const double truth = glm::dot(onBed - u, normal) / glm::dot(r, normal);
    const auto begun = optics64::intersectionBegin(u, r, seen(u));
    auto state = optics64::intersectionGuess(begun, truth + 0.3);
    EXPECT_DOUBLE_EQ(state.s, truth + 0.3);
    EXPECT_LT(glm::distance(state.W, u + (truth + 0.3) * r), 1e-12);
    state = optics64::intersectionStepSampled(state, seen(state.W));
    EXPECT_NEAR(state.s, truth, 1e-9);
    EXPECT_EQ(optics64::intersectionGuess(begun, -1.0).s, 0.0);
    const dvec3 upwards = glm::normalize(dvec3(0.1, 0.5, 0.8)); // comes back to the eye's plane
    EXPECT_LT(optics64::intersectionGuess(optics64::intersectionBegin(u, upwards, seen(u)), 100.0).W.z, 0.0);
}

} // namespace
} // namespace tarn

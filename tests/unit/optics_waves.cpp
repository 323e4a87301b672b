// The wave sum: slopes, dispersion, filtering, and what float costs far from the origin.

#include "optics/waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tarn {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double pi64 = std::numbers::pi;

std::vector<optics64::WaveTerm> someWaves()
{
    return {optics64::makeWaveTerm(0.05, 4.0, 0.3, 0.1), optics64::makeWaveTerm(0.03, 2.3, 1.7, 1.0),
            optics64::makeWaveTerm(0.01, 0.6, -2.5, 2.0, 0.9)};
}

std::vector<optics::WaveTerm> narrowed(const std::vector<optics64::WaveTerm>& waves)
{
    std::vector<optics::WaveTerm> result;
    for (const auto& w : waves)
        result.push_back(
            {vec2(w.k), float(w.omega), float(w.phase), float(w.amplitude), float(w.wavenumber), 0.0f, 0.0f});
    return result;
}

// shaders/shared/trigonometry.glsl states both bounds.
TEST(Trigonometry, SineAndCosineTogetherAreWithinTheirBound)
{
    double worst = 0.0, worst64 = 0.0;
    for (int i = -200000; i <= 200000; ++i) {
        const float angle = 1e-4f * static_cast<float>(i);
        const vec2 pair = optics::sinCosTogether(angle);
        const dvec2 pair64 = optics64::sinCosTogether(static_cast<double>(angle));
        const double s = std::sin(static_cast<double>(angle)), c = std::cos(static_cast<double>(angle));
        worst = std::max({worst, std::abs(static_cast<double>(pair.x) - s), std::abs(static_cast<double>(pair.y) - c)});
        worst64 = std::max({worst64, std::abs(pair64.x - s), std::abs(pair64.y - c)});
    }
    EXPECT_LT(worst64, 1e-8) << "of the polynomials";
    EXPECT_LT(worst, 2e-6) << "with float's rounding of the angle";
}

// A pixel's footprint along the wave, and two waves across it that it does not shorten.
TEST(Waves, APixelFiltersWhatItsEdgesSpanOfAWave)
{
    const auto wave = optics64::makeWaveTerm(0.05, 2.0, 0.7, 0.0);
    const dvec2 along = dvec2(std::cos(0.7), std::sin(0.7)), across(-along.y, along.x);
    EXPECT_NEAR(optics64::waveFilterOverPixel(wave, 0.3 * along, 5.0 * across), optics64::waveFilter(wave, 0.3), 1e-12);
    EXPECT_NEAR(optics64::waveFilterOverPixel(wave, 0.3 * along, 0.4 * along), optics64::waveFilter(wave, 0.5), 1e-12);
}

TEST(Waves, SlopeIsTheDerivativeOfTheHeight)
{
    const auto waves = someWaves();
    const double h = 1e-5;
    for (int i = 0; i < 200; ++i) {
        const dvec2 x(0.37 * i - 20.0, 11.0 - 0.21 * i);
        const double t = 0.1 * i;
        const auto sample = optics64::waveAt(waves, x, t);
        const double dx =
            (optics64::waveHeight(waves, x + dvec2(h, 0), t) - optics64::waveHeight(waves, x - dvec2(h, 0), t));
        const double dz =
            (optics64::waveHeight(waves, x + dvec2(0, h), t) - optics64::waveHeight(waves, x - dvec2(0, h), t));
        EXPECT_NEAR(sample.slope.x, dx / (2 * h), 1e-9);
        EXPECT_NEAR(sample.slope.y, dz / (2 * h), 1e-9);
        const dvec3 normal = optics64::waveNormalAt(waves, x, t);
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-14);
        // Perpendicular to both tangents.
        EXPECT_NEAR(glm::dot(normal, dvec3(1.0, sample.slope.x, 0.0)), 0.0, 1e-14);
        EXPECT_NEAR(glm::dot(normal, dvec3(0.0, sample.slope.y, 1.0)), 0.0, 1e-14);
    }
}

TEST(Waves, DeepWaterDispersion)
{
    // A wave of 1.56 m (g/2π) has a period of 1 s.
    const auto wave = optics64::makeWaveTerm(0.1, 9.81 / (2.0 * pi64), 0.0, 0.0);
    EXPECT_NEAR(wave.omega, 2.0 * pi64, 1e-12);
    EXPECT_NEAR(wave.omega * wave.omega, 9.81 * wave.wavenumber, 1e-12);
    EXPECT_NEAR(glm::length(wave.k), wave.wavenumber, 1e-14);
    // A given period wins.
    EXPECT_NEAR(optics64::makeWaveTerm(0.1, 3.0, 0.0, 0.0, 4.0).omega, 0.5 * pi64, 1e-14);
}

TEST(Waves, TravelAlongTheirDirection)
{
    const double direction = 2.1;
    const auto wave = optics64::makeWaveTerm(0.1, 3.0, direction, 0.4);
    const dvec2 x(1.0, 2.0);
    const double speed = wave.omega / wave.wavenumber, dt = 0.3;
    const dvec2 moved = x + speed * dt * dvec2(std::cos(direction), std::sin(direction));
    EXPECT_NEAR(optics64::waveTerm(wave, moved, dt).x, optics64::waveTerm(wave, x, 0.0).x, 1e-14);
    EXPECT_GT(std::abs(optics64::waveTerm(wave, x, dt).x - optics64::waveTerm(wave, x, 0.0).x), 1e-3);
}

TEST(Waves, StayWithinTheSumOfTheirAmplitudes)
{
    const auto waves = someWaves();
    const double limit = optics64::totalAmplitude(waves);
    EXPECT_NEAR(limit, 0.09, 1e-15);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1000.0, 1000.0);
    double highest = 0.0, squares = 0.0;
    const int count = 200000;
    for (int i = 0; i < count; ++i) {
        const auto sample = optics64::waveAt(waves, {any(random), any(random)}, any(random));
        highest = std::max(highest, std::abs(sample.height));
        squares += 0.5 * glm::dot(sample.slope, sample.slope);
    }
    EXPECT_LE(highest, limit);
    EXPECT_GT(highest, 0.9 * limit);
    EXPECT_NEAR(squares / count, optics64::slopeVariance(waves), 0.01 * optics64::slopeVariance(waves));
}

TEST(WaveFilter, GoesFromOneToNothing)
{
    const auto wave = optics64::makeWaveTerm(0.1, 2.0, 0.0, 0.0);
    EXPECT_EQ(optics64::waveFilter(wave, 0.0), 1.0);
    EXPECT_NEAR(optics64::waveFilter(wave, 1.0), 0.29, 0.005); // two footprints to a wave
    EXPECT_NEAR(optics64::waveFilter(wave, 2.0), 0.0072, 1e-4);
    EXPECT_EQ(optics64::waveFilter(wave, 1e6), 0.0);
    for (double f = 0.0; f < 5.0; f += 0.1)
        EXPECT_GT(optics64::waveFilter(wave, f), optics64::waveFilter(wave, f + 0.1));
}

/// The weight is what averaging a sine with that Gaussian leaves of it.
TEST(WaveFilter, IsTheAverageOverTheFootprint)
{
    const auto wave = optics64::makeWaveTerm(0.1, 2.0, 0.0, 0.9);
    const double footprint = 0.7, sigma = 0.5 * footprint, x = 0.3;
    double sum = 0.0, weights = 0.0;
    for (double u = -8.0 * sigma; u <= 8.0 * sigma; u += 1e-3) {
        const double weight = std::exp(-0.5 * u * u / (sigma * sigma));
        sum += weight * optics64::waveTerm(wave, {x + u, 0.0}, 0.0).x;
        weights += weight;
    }
    const double exact = optics64::waveTerm(wave, {x, 0.0}, 0.0).x;
    EXPECT_NEAR(sum / weights, optics64::waveFilter(wave, footprint) * exact, 1e-9);
}

/// A square pixel of this edge (m), along the axes.
optics64::FilteredWaves filtered(const std::vector<optics64::WaveTerm>& waves, const dvec2& x, double edge,
                                 double baseVariance = 0.0)
{
    return optics64::filteredWaves(waves.data(), static_cast<int>(waves.size()), x, 0.4, {edge, 0.0}, {0.0, edge},
                                   baseVariance);
}

TEST(WaveFilter, MovesTheVarianceItTakesToTheGlint)
{
    const auto waves = someWaves();
    const auto all = filtered(waves, {1.0, 2.0}, 1.0e5);
    EXPECT_NEAR(glm::length(all.meanSlope), 0.0, 1e-15);
    EXPECT_NEAR(all.slopeVariance, optics64::slopeVariance(waves), 1e-15);
    const auto some = filtered(waves, {1.0, 2.0}, 1.0);
    EXPECT_GT(some.slopeVariance, 0.0);
    EXPECT_LT(some.slopeVariance, all.slopeVariance);
    EXPECT_NEAR(filtered(waves, {1.0, 2.0}, 1.0, 0.02).slopeVariance, some.slopeVariance + 0.02, 1e-15);
}

TEST(WaveFilter, APointSeesTheSurfaceItself)
{
    const auto waves = someWaves();
    for (int i = 0; i < 100; ++i) {
        const dvec2 x(0.41 * i - 20.0, 7.0 - 0.3 * i);
        const auto point = filtered(waves, x, 0.0);
        EXPECT_EQ(point.slope, optics64::waveAt(waves, x, 0.4).slope);
        EXPECT_EQ(point.meanSlope, point.slope);
        EXPECT_EQ(point.slopeVariance, 0.0);
    }
}

/// The mean slope is the slope of waves whose amplitudes are what the filter leaves of them.
TEST(WaveFilter, TheMeanSlopeIsThatOfTheFilteredAmplitudes)
{
    const auto waves = someWaves();
    auto faded = waves;
    const double edge = 0.8;
    for (auto& w : faded) w.amplitude *= optics64::waveFilter(w, edge);
    for (int i = 0; i < 100; ++i) {
        const dvec2 x(0.41 * i - 20.0, 7.0 - 0.3 * i);
        const dvec2 difference = filtered(waves, x, edge).meanSlope - optics64::waveAt(faded, x, 0.4).slope;
        EXPECT_NEAR(glm::length(difference), 0.0, 1e-15);
    }
}

/// What the sun's photons meet: waves that their lattice cannot carry count less.
TEST(Waves, WeightsScaleTheAmplitudes)
{
    const auto waves = someWaves();
    const double weights[] = {1.0, 0.25, 0.0};
    auto scaled = waves;
    for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i].amplitude *= weights[i];
    for (int i = 0; i < 100; ++i) {
        const dvec2 x(0.41 * i - 20.0, 7.0 - 0.3 * i);
        const auto weighted = optics64::weightedWaveSum(waves.data(), 3, weights, x, 1.3);
        const auto expected = optics64::waveAt(scaled, x, 1.3);
        EXPECT_NEAR(weighted.height, expected.height, 1e-16);
        EXPECT_NEAR(glm::length(weighted.slope - expected.slope), 0.0, 1e-16);
    }
}

TEST(Waves, NoneOfThemIsALevelSurface)
{
    const std::vector<optics::WaveTerm> none;
    EXPECT_EQ(optics::waveHeight(none, vec2(3.0f), 1.0f), 0.0f);
    EXPECT_EQ(optics::waveNormalAt(none, vec2(3.0f), 1.0f), vec3(0.0f, 1.0f, 0.0f));
    const std::vector<optics::WaveTerm> still{optics::makeWaveTerm(0.0f, 1.0f, 0.2f, 0.3f)};
    EXPECT_EQ(optics::waveHeight(still, vec2(1.0e5f), 1.0e5f), 0.0f);
    EXPECT_EQ(optics::waveNormalAt(still, vec2(1.0e5f), 1.0e5f), vec3(0.0f, 1.0f, 0.0f));
}

/// float against double. The phase k·x - ωt is rounded to about 2^-24 of its largest part, three times over;
/// height and slope are off by that many radians. The bound is 4 · 2^-24 · (|k|·|x| + ωt + 2π) · amplitude.
TEST(Waves, FloatIsOffByTheRoundingOfThePhase)
{
    const auto waves = someWaves();
    const auto inFloat = narrowed(waves);
    std::mt19937 random(2);
    for (double reach : {1.0, 100.0, 1.0e5}) {
        for (double t : {0.0, 60.0, 1.0e5}) {
            double worst = 0.0;
            std::uniform_real_distribution<float> any(static_cast<float>(-reach), static_cast<float>(reach));
            for (int i = 0; i < 1000; ++i) {
                const vec2 x(any(random), any(random));
                const auto f = optics::waveAt(inFloat, x, static_cast<float>(t));
                double heightBound = 0.0, slopeBound = 0.0;
                // Against the double sum of the same float terms: it is the evaluation that is judged here.
                dvec3 exact(0.0);
                for (const auto& w : inFloat) {
                    const optics64::WaveTerm wide{dvec2(w.k), w.omega, w.phase, w.amplitude, w.wavenumber, 0.0, 0.0};
                    exact += optics64::waveTerm(wide, dvec2(x), t);
                    const double radians =
                        std::ldexp(4.0, -24) * (wide.wavenumber * glm::length(dvec2(x)) + wide.omega * t + 2.0 * pi64);
                    heightBound += radians * wide.amplitude;
                    slopeBound += radians * wide.amplitude * wide.wavenumber;
                }
                EXPECT_LE(std::abs(f.height - exact.x), heightBound) << reach << ' ' << t;
                EXPECT_LE(std::abs(f.slope.x - exact.y), slopeBound) << reach << ' ' << t;
                EXPECT_LE(std::abs(f.slope.y - exact.z), slopeBound) << reach << ' ' << t;
                worst = std::max(worst, std::abs(f.height - exact.x));
            }
            // Close by and at first it is a matter of nanometres.
            if (reach == 1.0 && t == 0.0) {
                EXPECT_LT(worst, 1e-7);
            }
        }
    }
}

/// With the time folded into the phase in double, days do not wear the waves out.
TEST(Waves, FoldedTimeKeepsItsPrecision)
{
    const auto waves = someWaves();
    for (double t : {0.0, 1.0e5, 1.0e7}) {
        std::vector<optics::WaveTerm> folded;
        for (const auto& w : waves) folded.push_back(optics64::waveTermAt(w, t));
        for (int i = 0; i < 100; ++i) {
            const dvec2 x(0.31 * i, -0.17 * i);
            EXPECT_NEAR(optics::waveHeight(folded, vec2(x), 123.0f), optics64::waveHeight(waves, x, t), 1e-6) << t;
        }
    }
}

} // namespace
} // namespace tarn

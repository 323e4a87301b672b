// The formulas that run per vertex or per pixel, float beside double.
#include "optics/waves.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace tarn {
namespace {

template <typename Term, typename Make> std::vector<Term> manyWaves(std::int64_t count, Make make)
{
    std::vector<Term> waves;
    for (std::int64_t i = 0; i < count; ++i) {
        const double number = static_cast<double>(i + 1);
        waves.push_back(make(0.1 / number, 8.0 / number, 0.7 * number));
    }
    return waves;
}

void waveSumFloat(benchmark::State& state)
{
    const auto waves = manyWaves<optics::WaveTerm>(state.range(0), [](double amplitude, double length, double way) {
        return optics::makeWaveTerm(static_cast<float>(amplitude), static_cast<float>(length), static_cast<float>(way),
                                    0.0f);
    });
    float x = 0.0f;
    for (auto _ : state) benchmark::DoNotOptimize(optics::waveAt(waves, vec2(x += 0.1f, 2.0f), 1.5f));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(waveSumFloat)->RangeMultiplier(4)->Range(1, 64);

void waveSumDouble(benchmark::State& state)
{
    const auto waves = manyWaves<optics64::WaveTerm>(state.range(0), [](double amplitude, double length, double way) {
        return optics64::makeWaveTerm(amplitude, length, way, 0.0);
    });
    double x = 0.0;
    for (auto _ : state) benchmark::DoNotOptimize(optics64::waveAt(waves, glm::dvec2(x += 0.1, 2.0), 1.5));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(waveSumDouble)->RangeMultiplier(4)->Range(1, 64);

void fresnelSchlick(benchmark::State& state)
{
    float cosTheta = 0.0f;
    for (auto _ : state) {
        cosTheta = cosTheta < 1.0f ? cosTheta + 1e-4f : 0.0f;
        benchmark::DoNotOptimize(optics::fresnelSchlick(cosTheta, 1.33f, 5.0f));
    }
}
BENCHMARK(fresnelSchlick);

void fresnelExact(benchmark::State& state)
{
    float cosTheta = 0.0f;
    for (auto _ : state) {
        cosTheta = cosTheta < 1.0f ? cosTheta + 1e-4f : 0.0f;
        benchmark::DoNotOptimize(optics::fresnelExact(cosTheta, 1.0f / 1.33f));
    }
}
BENCHMARK(fresnelExact);

} // namespace
} // namespace tarn

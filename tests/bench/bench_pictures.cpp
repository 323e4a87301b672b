// What a picture test costs besides the rendering.
#include "measure/image_compare.h"

#include <benchmark/benchmark.h>

namespace tarn {
namespace {

void comparePicturesOf(benchmark::State& state)
{
    const int width = static_cast<int>(state.range(0));
    Image image{"grey", width, width * 3 / 4, 3, {}, {}};
    image.bytes.assign(image.size(), 100);
    for (auto _ : state) benchmark::DoNotOptimize(comparePictures(image, image));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(image.size()));
}
BENCHMARK(comparePicturesOf)->Arg(320)->Arg(1024);

} // namespace
} // namespace tarn

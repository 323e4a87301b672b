#include "measure/statistics.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace tarn {

namespace {

double percentileOfSorted(const std::vector<double>& sorted, double fraction)
{
    const double rank = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    const double floor = std::floor(rank);
    const auto below = static_cast<std::size_t>(floor);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (rank - floor) * (sorted[above] - sorted[below]);
}

std::vector<double> sortedCopy(std::span<const double> samples)
{
    if (samples.empty()) throw Error("no samples to summarise; measure at least one frame");
    std::vector<double> sorted(samples.begin(), samples.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

} // namespace

double percentile(std::span<const double> samples, double fraction)
{
    return percentileOfSorted(sortedCopy(samples), fraction);
}

Summary summarise(std::span<const double> samples)
{
    const std::vector<double> sorted = sortedCopy(samples);
    Summary summary;
    summary.count = sorted.size();
    summary.minimum = sorted.front();
    summary.median = percentileOfSorted(sorted, 0.5);
    summary.mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
    summary.p95 = percentileOfSorted(sorted, 0.95);
    summary.p99 = percentileOfSorted(sorted, 0.99);
    summary.maximum = sorted.back();
    return summary;
}

namespace {

void requirePairs(std::span<const double> a, std::span<const double> b)
{
    if (a.size() != b.size())
        throw Error("{} samples cannot be paired with {}; measure as many of each", a.size(), b.size());
    if (a.empty()) throw Error("no samples to compare; measure at least one frame");
}

} // namespace

double totalRatio(std::span<const double> a, std::span<const double> b)
{
    requirePairs(a, b);
    return std::accumulate(a.begin(), a.end(), 0.0) / std::accumulate(b.begin(), b.end(), 0.0);
}

double medianRatio(std::span<const double> a, std::span<const double> b)
{
    requirePairs(a, b);
    std::vector<double> ratios(a.size());
    std::transform(a.begin(), a.end(), b.begin(), ratios.begin(), [](double x, double y) { return x / y; });
    return percentile(ratios, 0.5);
}

} // namespace tarn

// The figures that stand for a row of samples.
#pragma once

#include <cstddef>
#include <span>

namespace tarn {

/// The value below which `fraction` (0 to 1) of the samples lie, interpolated between neighbours
/// (Hyndman & Fan 1996, definition 7). Throws Error when there are no samples.
double percentile(std::span<const double> samples, double fraction);

struct Summary {
    std::size_t count = 0;
    double minimum = 0.0, median = 0.0, mean = 0.0, p95 = 0.0, p99 = 0.0, maximum = 0.0;
};

/// Throws Error when there are no samples.
Summary summarise(std::span<const double> samples);

/// Median of a[i] / b[i]. Neighbours in time share the machine's mood, so that their ratio is steadier than
/// the ratio of the medians. Throws Error unless both hold the same number of samples, at least one.
double medianRatio(std::span<const double> a, std::span<const double> b);

/// Sum of a over the sum of b: what a flight costs as a whole. The same conditions.
double totalRatio(std::span<const double> a, std::span<const double> b);

} // namespace tarn

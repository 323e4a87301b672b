// Which of many settings are worth their cost: the Pareto front.
#pragma once

#include "measure/error_figures.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tarn {

struct CostedError {
    double cost = 0.0, error = 0.0;
};

/// Those points that no other beats: none is at most as dear and at most as wrong, and better in one of the
/// two. Of equal points the first stands for all; one whose cost or error is NaN is never on the front.
/// @return indices from cheap to dear, with falling error
std::vector<std::size_t> paretoFront(std::span<const CostedError> points);

/// A figure as an error, zero at best: the flux ratio's distance from 1, the negative of a PSNR, others as
/// they are.
double errorOf(const FigureField& field, const ErrorFigures& figures);

} // namespace tarn

// How much of a frame's error each of its approximations owns (docs/accuracy.md).
#pragma once

#include "measure/error_figures.h"

#include <string>
#include <vector>

namespace tarn {

/// Parts and whole from both ends: the reference with approximations put into it, the frame with them taken
/// out. NaN stands for what was not, or cannot be, measured.
struct ErrorBudget {
    static constexpr double none = ErrorFigures::none;
    struct Row {
        std::string part;
        double alone = none;   ///< error of the reference with this approximation in it
        double removed = none; ///< by how much the frame's error falls when this part of it is exact
        std::string exact{};   ///< the options that make it so: "refraction.steps=24"
    };
    std::string quantity; ///< "mean FLIP"
    std::vector<Row> rows;
    double total = 0.0;       ///< error of the frame as it is
    double together = none;   ///< error of the reference with every part in it that has a value alone
    double remaining = none;  ///< error of the frame with every part exact: what the parts do not explain
    double noise = none;      ///< of the reference: its error against itself with other random numbers
    double unmodelled = none; ///< what light between surfaces changes in the reference; neither side of `total` has it
};

/// Sum over the rows that have a value; none when no row has one.
double sumOfParts(const ErrorBudget& budget, double ErrorBudget::Row::*figure);

/// As a person reads it, columns of fixed width.
std::string budgetTable(const ErrorBudget& budget);

} // namespace tarn

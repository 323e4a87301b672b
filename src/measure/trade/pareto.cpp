#include "measure/trade/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace tarn {

std::vector<std::size_t> paretoFront(std::span<const CostedError> points)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!std::isnan(points[i].cost) && !std::isnan(points[i].error)) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (points[a].cost != points[b].cost) return points[a].cost < points[b].cost;
        return points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (!front.empty() && points[i].error >= least) continue;
        least = points[i].error;
        front.push_back(i);
    }
    return front;
}

double errorOf(const FigureField& field, const ErrorFigures& figures)
{
    const double value = figures.*field.member;
    if (std::string_view(field.name) == "caustics.energy") return std::abs(value - 1.0);
    return field.smallerIsBetter ? value : -value;
}

} // namespace tarn

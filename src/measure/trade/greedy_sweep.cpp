#include "measure/trade/greedy_sweep.h"

#include <cmath>

namespace tarn {

namespace {

constexpr double cellsOfCost = 1000.0; // keeps the front of sums from growing with every option

/// Some of the options decided: which value of each, and what they add together.
struct Partial {
    std::vector<std::size_t> chosen;
    double cost = 0.0, error = 0.0;
};

/// What has both a cost and an error; options without such a value are left out.
std::vector<SweptOption> measuredOnly(std::span<const SweptOption> options)
{
    std::vector<SweptOption> result;
    for (SweptOption option : options) {
        std::erase_if(option.values, [](const SweptOption::Value& value) {
            return std::isnan(value.cost) || std::isnan(value.error);
        });
        if (!option.values.empty()) result.push_back(std::move(option));
    }
    return result;
}

std::vector<Partial> frontOf(const std::vector<Partial>& partials)
{
    std::vector<CostedError> points;
    for (const Partial& partial : partials) points.push_back({partial.cost, partial.error});
    std::vector<Partial> front;
    for (const std::size_t i : paretoFront(points)) front.push_back(partials[i]);
    return front;
}

/// One for each cell of cost, the cheapest aside; a front's last in a cell is its most accurate.
std::vector<Partial> coarsened(const std::vector<Partial>& front)
{
    const double first = front.front().cost, range = front.back().cost - first;
    const auto cell = [&](const Partial& partial) { return std::floor(cellsOfCost * (partial.cost - first) / range); };
    std::vector<Partial> result{front.front()};
    for (std::size_t i = 1; i < front.size(); ++i)
        if (i + 1 == front.size() || cell(front[i]) != cell(front[i + 1])) result.push_back(front[i]);
    return result;
}

std::vector<Partial> extended(const std::vector<Partial>& front, const SweptOption& option, const CostedError& base)
{
    std::vector<Partial> all;
    for (const Partial& partial : front)
        for (std::size_t value = 0; value < option.values.size(); ++value) {
            Partial next = partial;
            next.chosen.push_back(value);
            next.cost += option.values[value].cost - base.cost;
            next.error += option.values[value].error - base.error;
            all.push_back(std::move(next));
        }
    return all;
}

/// How far along the front each step is, 0 to 1, with cost and error in parts of their ranges.
std::vector<double> lengthsAlong(const std::vector<SweepStep>& steps)
{
    const double costs = steps.back().cost - steps.front().cost;
    const double errors = steps.front().error - steps.back().error;
    const auto part = [](double difference, double range) { return range > 0.0 ? std::abs(difference) / range : 0.0; };
    std::vector<double> lengths{0.0};
    for (std::size_t i = 1; i < steps.size(); ++i)
        lengths.push_back(lengths.back() + std::hypot(part(steps[i].cost - steps[i - 1].cost, costs),
                                                      part(steps[i].error - steps[i - 1].error, errors)));
    for (double& length : lengths) length = lengths.back() > 0.0 ? length / lengths.back() : 0.0;
    return lengths;
}

} // namespace

std::vector<SweepStep> predictedFront(std::span<const SweptOption> options, const CostedError& base)
{
    const std::vector<SweptOption> measured = measuredOnly(options);
    if (measured.empty()) return {};
    std::vector<Partial> front{{{}, base.cost, base.error}};
    for (const SweptOption& option : measured) front = coarsened(frontOf(extended(front, option, base)));
    std::vector<SweepStep> steps;
    for (const Partial& partial : front) {
        SweepStep step{{}, partial.cost, partial.error};
        for (std::size_t i = 0; i < measured.size(); ++i)
            step.changes[measured[i].key] = measured[i].values[partial.chosen[i]].value;
        steps.push_back(std::move(step));
    }
    return steps;
}

std::vector<SweepStep> thinned(const std::vector<SweepStep>& steps, std::size_t count)
{
    if (steps.size() <= count || count < 2) return steps;
    const std::vector<double> lengths = lengthsAlong(steps);
    std::vector<SweepStep> result;
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double wanted = static_cast<double>(i) / static_cast<double>(count - 1);
        const std::size_t last = steps.size() - (count - i); // leaves a step for each that is still to come
        while (next < last && lengths[next] < wanted) ++next;
        result.push_back(steps[next++]);
    }
    return result;
}

} // namespace tarn

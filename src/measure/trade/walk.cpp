#include "measure/trade/walk.h"

#include <cmath>
#include <limits>

namespace tarn {

namespace {

/// The options that have something to choose from, and what is chosen now.
struct State {
    std::vector<SweptOption> options;
    std::vector<std::size_t> chosen;

    const SweptOption::Value& value(std::size_t option) const
    {
        return options[option].values[chosen[option]];
    }

    WalkStep step() const
    {
        WalkStep result;
        for (std::size_t i = 0; i < options.size(); ++i) {
            result.changes[options[i].key] = value(i).value;
            result.price += value(i).price;
            result.error += value(i).error;
        }
        return result;
    }
};

State cheapest(std::span<const SweptOption> options)
{
    State state;
    for (const SweptOption& option : options) {
        SweptOption measured{option.key, {}};
        std::size_t best = 0;
        for (const SweptOption::Value& value : option.values) {
            if (std::isnan(value.price) || std::isnan(value.error)) continue;
            measured.values.push_back(value);
            const SweptOption::Value& other = measured.values[best];
            if (value.price < other.price || (value.price == other.price && value.error < other.error))
                best = measured.values.size() - 1;
        }
        if (measured.values.empty()) continue;
        state.options.push_back(std::move(measured));
        state.chosen.push_back(best);
    }
    return state;
}

/// Error removed for each millisecond; infinite when the change is free, negative when it removes none.
double worth(const SweptOption::Value& from, const SweptOption::Value& to)
{
    if (to.error >= from.error) return -1.0;
    if (to.price <= from.price) return std::numeric_limits<double>::infinity();
    return (from.error - to.error) / (to.price - from.price);
}

/// False when no change removes error any more.
bool takeBestChange(State& state)
{
    double best = 0.0;
    std::size_t option = 0, value = 0;
    for (std::size_t i = 0; i < state.options.size(); ++i)
        for (std::size_t j = 0; j < state.options[i].values.size(); ++j) {
            const double gain = worth(state.value(i), state.options[i].values[j]);
            if (gain <= best) continue;
            best = gain;
            option = i;
            value = j;
        }
    if (best <= 0.0) return false;
    state.chosen[option] = value;
    return true;
}

} // namespace

std::vector<WalkStep> greedyWalk(std::span<const SweptOption> options)
{
    State state = cheapest(options);
    if (state.options.empty()) return {};
    std::vector<WalkStep> steps{state.step()};
    while (takeBestChange(state)) // ends, for each change lowers the error of one of finitely many values
        steps.push_back(state.step());
    return steps;
}

std::vector<WalkStep> thinned(const std::vector<WalkStep>& steps, std::size_t count)
{
    if (steps.size() <= count || count < 2) return steps;
    std::vector<WalkStep> result;
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(steps[i * (steps.size() - 1) / (count - 1)]);
    return result;
}

} // namespace tarn

// Presets out of a trade: few settings that stand for the whole front.
//
// All five are points of the Pareto front of mean time against mean FLIP. `best` has the least error. `fast` is the
// cheapest that is no less accurate than the thesis' settings, or the cheapest of all where they were not measured.
// `low` is the most accurate that costs no more than the thesis' settings, or the cheapest where the thesis was not
// measured. The way between their costs is cut into three equal factors: `medium` and `high` are the most
// accurate points that cost no more than the first and the second cut.
#pragma once

#include "measure/trade/results.h"

#include <string>
#include <vector>

namespace tarn {

struct PresetPick {
    std::string name;
    std::size_t point = 0; ///< index into the results
};

/// fast, low, medium, high, best; of a ladder's plan, which measures nothing dearer than the base, fast alone. Throws
/// Error when no point has both a cost and an error.
std::vector<PresetPick> pickPresets(const TradeSetup& setup, const TradeResults& results);

/// "12.3 ms a frame, mean FLIP 0.0456, …", for people.
std::string measuredText(const Measured& measured);

/// A file for --options: every option that the plan's sweeps and presets know, whatever the base.
/// @param comment lines at its head
std::string presetText(const TradeSetup& setup, const TradePoint& point, const std::vector<std::string>& comment);

/// As a TOML file writes it.
std::string tomlValue(const FieldRow& row);
std::string tomlString(const std::string& text);

/// The options of a file for --options: those keys, with the values of these rows.
std::string optionsText(const std::vector<FieldRow>& rows, const std::vector<std::string>& keys);

} // namespace tarn

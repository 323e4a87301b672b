// Options in a TOML table, wherever it stands. Only for sources that read TOML.
#pragma once

#include "base/fields.h"

#include <toml++/toml.h>

#include <string>
#include <vector>

namespace tarn {

/// [refraction] steps = 3, or refraction.steps = 3, with the line of each. Throws UsageError for a value of a kind that
/// no option has. @param file for messages
std::vector<Assignment> assignmentsOf(const toml::table& table, const std::string& file);

} // namespace tarn

// Values on the command line. Each throws UsageError that names the flag and says what it wants.
#pragma once

#include "base/math.h"

#include <string_view>

namespace tarn
{

/// "640x480"; each edge from 1 to 16384 pixels.
ivec2 parseSize(std::string_view text, std::string_view flag);

/// "1.5,-2,3": finite numbers.
vec3 parseVec3(std::string_view text, std::string_view flag);

/// A finite number from lower to upper.
double parseNumber(std::string_view text, std::string_view flag, double lower, double upper);

int parseCount(std::string_view text, std::string_view flag, int lower, int upper);

} // namespace tarn

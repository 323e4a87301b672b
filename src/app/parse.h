// Values on the command line. Each throws UsageError that names the flag and says what it wants.
#pragma once

#include "base/math.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tarn {

/// "640x480"; each edge from 1 to 16384 pixels.
ivec2 parseSize(std::string_view text, std::string_view flag);

/// "1.5,-2,3": finite numbers.
vec3 parseVec3(std::string_view text, std::string_view flag);

/// A finite number from lower to upper.
double parseNumber(std::string_view text, std::string_view flag, double lower, double upper);

int parseCount(std::string_view text, std::string_view flag, int lower, int upper);

/// "a,b,c": at least one, none of them empty or twice.
std::vector<std::string> parseNames(std::string_view text, std::string_view flag);

/// "0,1.7": finite numbers, each once.
std::vector<double> parseNumbers(std::string_view text, std::string_view flag);

/// "2/4": the part and the number of parts.
std::pair<int, int> parseShard(std::string_view text, std::string_view flag);

} // namespace tarn

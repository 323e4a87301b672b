// What the scanners of OBJ and MTL text share. Private to src/scene.
#pragma once

#include <string>
#include <string_view>

namespace tarn {

/// Makes every line end with \n and nothing else, and blanks a UTF-8 byte-order mark. Lines keep their
/// numbers.
void normaliseLines(std::string& text);

inline bool isBlank(char c) { return c == ' ' || c == '\t'; }

/// Without blanks at both ends.
std::string_view trimBlanks(std::string_view text);

/// Takes the next blank-separated word off the front of `rest`; empty at the end.
std::string_view nextWord(std::string_view& rest);

/// A decimal number that a float can hold: not nan, not inf, nothing after it.
bool isNumber(std::string_view word);

} // namespace tarn

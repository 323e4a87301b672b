#include "scene/text_scan.h"

#include <algorithm>
#include <cstdlib>

namespace tarn {

void normaliseLines(std::string& text)
{
    if (text.starts_with("\xef\xbb\xbf")) std::fill_n(text.begin(), 3, ' ');
    for (std::size_t at = text.find('\r'); at != std::string::npos; at = text.find('\r', at + 1))
        text[at] = at + 1 < text.size() && text[at + 1] == '\n' ? ' ' : '\n'; // a lone \r ends lines of old Macs
}

std::string_view trimBlanks(std::string_view text)
{
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view nextWord(std::string_view& rest)
{
    std::size_t start = 0;
    while (start < rest.size() && isBlank(rest[start])) ++start;
    std::size_t end = start;
    while (end < rest.size() && !isBlank(rest[end])) ++end;
    const auto word = rest.substr(start, end - start);
    rest.remove_prefix(end);
    return word;
}

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t skipDigits(std::string_view word, std::size_t at)
{
    while (at < word.size() && isDigit(word[at])) ++at;
    return at;
}

} // namespace

bool isNumber(std::string_view word)
{
    const std::size_t start = !word.empty() && (word[0] == '-' || word[0] == '+') ? 1 : 0;
    std::size_t at = skipDigits(word, start);
    std::size_t digits = at - start;
    const std::size_t wholeDigits = digits;
    if (at < word.size() && word[at] == '.') {
        const std::size_t end = skipDigits(word, at + 1);
        digits += end - at - 1;
        at = end;
    }
    if (digits == 0) return false;

    long exponent = 0;
    if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
        const std::size_t sign = at + 1 < word.size() && (word[at + 1] == '-' || word[at + 1] == '+') ? 1 : 0;
        const std::size_t end = skipDigits(word, at + 1 + sign);
        if (end == at + 1 + sign || end - at > 8) return false;
        exponent = std::strtol(std::string(word.substr(at + 1, end - at - 1)).c_str(), nullptr, 10);
        at = end;
    }
    // FLT_MAX is 3.4e38; below 1e37 nothing can overflow.
    return at == word.size() && exponent > -300 && static_cast<long>(wholeDigits) + exponent <= 37;
}

} // namespace tarn

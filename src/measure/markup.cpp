#include "measure/markup.h"

#include <cstddef>
#include <cstdint>

namespace tarn {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd"; // U+FFFD

/// How many bytes of `text` are one character that XML 1.0 has (production 2, Char); 0 when its first byte begins none.
std::size_t characterLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t first = byte(0);
    if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
    std::uint32_t code = first & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    const bool isOverlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool isSurrogate = code >= 0xd800 && code <= 0xdfff;
    return isOverlong || isSurrogate || code == 0xfffe || code == 0xffff || code > 0x10ffff ? 0 : length;
}

} // namespace

std::string escapedMarkup(std::string_view text)
{
    std::string result;
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        switch (length == 1 ? text.front() : '\0') {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        case '\'': result += "&#39;"; break;
        case '\t': result += "&#9;"; break; // in an attribute it would be read as a blank
        case '\n': result += "&#10;"; break;
        case '\r': result += "&#13;"; break;
        default: result += length > 0 ? text.substr(0, length) : replacement;
        }
        text.remove_prefix(length > 0 ? length : 1);
    }
    return result;
}

} // namespace tarn

// Text in HTML and XML.
#pragma once

#include <string>
#include <string_view>

namespace tarn {

/// Text fit for the content and the attributes of HTML and of XML 1.0. Bytes that are no UTF-8 and characters that XML
/// does not have (names of files may hold both) become U+FFFD.
std::string escapedMarkup(std::string_view text);

} // namespace tarn

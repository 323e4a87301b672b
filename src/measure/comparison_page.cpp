#include "measure/comparison_page.h"

#include "measure/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace tarn {

namespace {

std::string picture(const char* style, const char* label, const std::optional<std::string>& source)
{
    if (!source) return fmt::format("<p class=\"{} none\">no {} picture</p>", style, label);
    return fmt::format("<img class=\"{}\" alt=\"{}\" title=\"{}\" src=\"{}\">", style, label, label,
                       escapedMarkup(*source));
}

std::string section(const ComparisonEntry& entry)
{
    std::string html =
        fmt::format("<section>\n<h2>{}</h2>\n<p>{}</p>\n<p><strong>{}</strong></p>\n<div class=\"row\">\n",
                    escapedMarkup(entry.name), escapedMarkup(entry.description), escapedMarkup(entry.verdict));
    html += fmt::format("<figure>{}<figcaption>expected</figcaption></figure>\n",
                        picture("plain", "expected", entry.expected));
    html +=
        fmt::format("<figure>{}<figcaption>actual</figcaption></figure>\n", picture("plain", "actual", entry.actual));
    html += fmt::format("<figure>{}<figcaption>difference, 16 times</figcaption></figure>\n",
                        picture("plain", "difference", entry.difference));
    if (entry.expected && entry.actual)
        html += fmt::format("<figure class=\"flip\">{}{}<figcaption>actual; expected under the pointer"
                            "</figcaption></figure>\n",
                            picture("under", "expected", entry.expected), picture("over", "actual", entry.actual));
    return html + "</div>\n</section>\n";
}

constexpr const char* head = R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<style>
body { font: 15px/1.4 sans-serif; background: #888; color: #000; margin: 1em; }
section { background: #ccc; padding: 0.5em 1em; margin-bottom: 1em; }
h2 { margin: 0.2em 0; }
p { margin: 0.2em 0; }
.row { display: flex; flex-wrap: wrap; gap: 1em; }
figure { margin: 0; }
img { display: block; image-rendering: pixelated; min-width: 320px; max-width: 100%; }
.none { width: 320px; height: 240px; background: #aaa; text-align: center; }
.flip { position: relative; cursor: crosshair; }
.flip .over { position: absolute; top: 0; left: 0; }
.flip:hover .over { visibility: hidden; }
</style>
)";

} // namespace

std::string base64(const std::string& bytes)
{
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8 | (j < count ? static_cast<std::uint8_t>(bytes[i + j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j) text += j <= count ? digits[group >> (18 - 6 * j) & 63u] : '=';
    }
    return text;
}

std::string embeddedPng(const std::string& png) { return "data:image/png;base64," + base64(png); }

std::string comparisonPage(const std::string& title, const std::vector<ComparisonEntry>& entries,
                           const std::vector<PassedCase>& passed)
{
    std::string html = fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<title>{}</title>\n{}<h1>{}</h1>\n",
                                   escapedMarkup(title), head, escapedMarkup(title));
    for (const ComparisonEntry& entry : entries) html += section(entry);
    if (!passed.empty()) {
        html += "<section>\n<h2>Passed</h2>\n<ul>\n";
        for (const PassedCase& test : passed)
            html += fmt::format("<li><strong>{}</strong>: {}</li>\n", escapedMarkup(test.name),
                                escapedMarkup(test.verdict));
        html += "</ul>\n</section>\n";
    }
    return html + "</html>\n";
}

} // namespace tarn

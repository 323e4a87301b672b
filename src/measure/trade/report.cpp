#include "measure/trade/report.h"

#include "base/error.h"
#include "base/files.h"
#include "measure/comparison_page.h"
#include "measure/trade/trade_json.h"

#include <algorithm>

namespace tarn {

namespace {

using nlohmann::json;

std::filesystem::path partFile(const char* name) { return projectRoot() / "assets" / "report" / name; }

std::filesystem::path chartFile()
{
    const std::filesystem::path file = TARN_CHART_JS;
    if (!std::filesystem::exists(file))
        throw Error("{}: the report's plots need Chart.js; install libjs-chart.js", file.string());
    return file;
}

std::string replaced(std::string text, std::string_view what, std::string_view with)
{
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

/// JavaScript that may stand inside <script>: only within strings can it hold the closing tag.
std::string scriptText(const std::filesystem::path& file) { return replaced(readFile(file), "</script", "<\\/script"); }

std::string htmlText(const std::string& text)
{
    return replaced(replaced(replaced(text, "&", "&amp;"), "<", "&lt;"), "\"", "&quot;");
}

/// A stored PNG as the page shows it; empty when it was not made.
std::string pictureUrl(const TradeStore& store, const std::string& name)
{
    return store.has(name) ? "data:image/png;base64," + base64(store.read(name)) : "";
}

json picturesJson(const TradeSetup& setup, const TradeStore& store)
{
    json references = json::array(), points = json::array();
    for (std::size_t view = 0; view < setup.views.size(); ++view)
        references.push_back(pictureUrl(store, fmt::format("reference-view{}.png", view)));
    for (const TradePoint& point : picturedPoints(setup.plan)) {
        json entry{{"point", point.id}, {"real_time", json::array()}, {"flip", json::array()}};
        for (std::size_t view = 0; view < setup.views.size(); ++view) {
            const std::string name = TradeUnit{TradeUnit::Kind::pictures, {point}, view, 0}.name();
            entry["real_time"].push_back(pictureUrl(store, name + "-realtime.png"));
            entry["flip"].push_back(pictureUrl(store, name + "-flip.png"));
        }
        points.push_back(std::move(entry));
    }
    return {{"references", std::move(references)}, {"points", std::move(points)}};
}

/// What the page does not show makes it no larger.
json withoutTimes(json data)
{
    for (json& point : data["points"])
        for (json& view : point["views"]) view.erase("times");
    return data;
}

/// Fills "{{name}}" in one go, so that what stands in a part is never taken for a place to fill.
std::string filled(const std::string& page, const std::vector<std::pair<std::string, std::string>>& parts)
{
    std::string result;
    std::size_t from = 0;
    for (std::size_t at = page.find("{{"); at != std::string::npos; at = page.find("{{", from)) {
        result.append(page, from, at - from);
        const std::size_t end = page.find("}}", at);
        const std::string name = page.substr(at + 2, end - at - 2);
        const auto part =
            std::find_if(parts.begin(), parts.end(), [&](const auto& entry) { return entry.first == name; });
        if (part == parts.end()) throw Error("{}: unknown place {}", partFile("page.html").string(), name);
        result += part->second;
        from = end + 2;
    }
    return result.append(page, from);
}

} // namespace

std::string scriptJson(const json& value)
{
    return replaced(value.dump(-1, ' ', false, json::error_handler_t::replace), "<", "\\u003c");
}

void requireReportParts()
{
    chartFile();
    for (const char* name : {"page.html", "style.css", "plots.js", "page.js"})
        if (!std::filesystem::exists(partFile(name))) throw Error("{}: missing", partFile(name).string());
}

std::string tradeReport(const TradeSetup& setup, const TradeResults& results, const TradeStore& store,
                        const ReportHead& head)
{
    json data = withoutTimes(toJson(setup, results, head.command));
    data["title"] = head.title;
    data["date"] = head.date;
    data["pictures"] = picturesJson(setup, store);
    return filled(readFile(partFile("page.html")), {{"title", htmlText(head.title)},
                                                    {"style", readFile(partFile("style.css"))},
                                                    {"chart", scriptText(chartFile())},
                                                    {"data", scriptJson(data)},
                                                    {"plots", scriptText(partFile("plots.js"))},
                                                    {"page", scriptText(partFile("page.js"))}});
}

} // namespace tarn

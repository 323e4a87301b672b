#include "measure/paper_tables.h"

#include "base/error.h"
#include "measure/statistics.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace tarn {

namespace {

PaperRow textureRow(int resolution)
{
    return {fmt::format("{0}x{0}", resolution),
            {fmt::format("refraction.target_size={}", resolution), fmt::format("reflection.target_size={}", resolution),
             fmt::format("caustics.texture_size={}", resolution)}};
}

std::vector<PaperTable> makeTables()
{
    return {{.number = 2,
             .title = "caustics on and off",
             .rows = {{"caustics on", {"caustics.enabled=true"}}, {"caustics off", {"caustics.enabled=false"}}},
             .base = 1,
             .cards = {{"ATI Radeon X800", {27.0, 75.0}},
                       {"GeForce 7950GT", {130.0, 170.0}},
                       {"GeForce 6800", {57.0, 69.0}}}},
            {.number = 3,
             .title = "size of the refraction, reflection and caustics textures",
             .rows = {textureRow(256), textureRow(512), textureRow(1024)},
             .base = 0,
             .cards = {{"ATI Radeon X800", {31.0, 28.0, 17.0}}}}};
}

/// A row measured here beside one card of the thesis.
struct Comparison {
    double framesPerSecond, ratio; ///< the card's
    double oursOverThesis;         ///< of the ratios
};

struct Measured {
    double medianMs, framesPerSecond;
    double ratio; ///< of frame rates, against the base
    std::vector<Comparison> cards;
};

std::vector<Measured> measure(const PaperTable& table, const BenchReport& report)
{
    if (report.results.size() != table.rows.size())
        throw Error("table {} has {} rows, but {} configurations were measured", table.number, table.rows.size(),
                    report.results.size());
    const std::vector<double>& base = report.results[table.base].frame.wallMs;
    std::vector<Measured> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const std::vector<double>& times = report.results[i].frame.wallMs;
        const double medianMs = percentile(times, 0.5);
        Measured row{medianMs, 1e3 / medianMs, medianRatio(base, times), {}};
        for (const PaperCard& card : table.cards) {
            const double ratio = card.framesPerSecond[i] / card.framesPerSecond[table.base];
            row.cards.push_back({card.framesPerSecond[i], ratio, row.ratio / ratio});
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Passes in drawing order. One that only some configurations run stands where the first of them runs it.
std::vector<std::string> passNames(const BenchReport& report)
{
    std::vector<std::string> names;
    for (const BenchResult& result : report.results) {
        auto position = names.begin();
        for (const auto& [name, series] : result.passes) {
            const auto known = std::find(names.begin(), names.end(), name);
            position = (known != names.end() ? known : names.insert(position, name)) + 1;
        }
    }
    return names;
}

std::optional<double> passMedian(const BenchResult& result, const std::string& pass)
{
    for (const auto& [name, series] : result.passes)
        if (name == pass && !series.wallMs.empty()) return percentile(series.wallMs, 0.5);
    return std::nullopt;
}

using Cells = std::vector<std::string>;

/// Columns are padded, so that the table reads as well in a terminal; all but the first are of numbers and
/// stand to the right. Cells are ASCII.
std::string markdownTable(const std::vector<Cells>& rows)
{
    std::vector<std::size_t> widths(rows.front().size(), 3);
    for (const Cells& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t i = 0; i < rows[r].size(); ++i)
            text += i == 0 ? fmt::format("| {:<{}} |", rows[r][i], widths[i])
                           : fmt::format(" {:>{}} |", rows[r][i], widths[i]);
        text += '\n';
        if (r > 0) continue;
        for (std::size_t i = 0; i < widths.size(); ++i)
            text += i == 0 ? fmt::format("| {:-<{}} |", "", widths[i]) : fmt::format(" {:->{}} |", ":", widths[i]);
        text += '\n';
    }
    return text;
}

std::string frameTable(const PaperTable& table, const BenchReport& report)
{
    Cells head{"", "median ms", "fps", "ratio"};
    for (const PaperCard& card : table.cards) {
        head.push_back(card.name);
        head.push_back("ours / thesis");
    }
    std::vector<Cells> rows{head};
    const std::vector<Measured> measured = measure(table, report);
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const Measured& m = measured[i];
        Cells row{table.rows[i].name, fmt::format("{:.2f}", m.medianMs), fmt::format("{:.1f}", m.framesPerSecond),
                  fmt::format("{:.2f}", m.ratio)};
        for (const Comparison& card : m.cards) {
            row.push_back(fmt::format("{:.0f} fps, {:.2f}", card.framesPerSecond, card.ratio));
            row.push_back(fmt::format("{:.2f}", card.oursOverThesis));
        }
        rows.push_back(std::move(row));
    }
    return markdownTable(rows);
}

std::string passTable(const PaperTable& table, const BenchReport& report)
{
    Cells head{"pass, median ms"};
    for (const PaperRow& row : table.rows) head.push_back(row.name);
    std::vector<Cells> rows{head};
    for (const std::string& name : passNames(report)) {
        Cells row{name};
        for (const BenchResult& result : report.results) {
            const std::optional<double> ms = passMedian(result, name);
            row.push_back(ms ? fmt::format("{:.2f}", *ms) : "-");
        }
        rows.push_back(std::move(row));
    }
    return markdownTable(rows);
}

} // namespace

std::span<const PaperTable> paperTables()
{
    static const std::vector<PaperTable> tables = makeTables();
    return tables;
}

const PaperTable& findPaperTable(std::string_view number, std::string_view flag)
{
    std::vector<std::string> choices;
    for (const PaperTable& table : paperTables()) {
        if (number == std::to_string(table.number)) return table;
        choices.push_back(fmt::format("{} ({})", table.number, table.title));
    }
    throw UsageError("{} {}: no such table; there are {}", flag, number, fmt::join(choices, " and "));
}

nlohmann::json toJson(const PaperTable& table, const BenchReport& report)
{
    nlohmann::json json = toJson(report);
    json.erase("ratios"); // the table has its own, against its base
    nlohmann::json rows = nlohmann::json::array();
    const std::vector<Measured> measured = measure(table, report);
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const Measured& m = measured[i];
        nlohmann::json thesis = nlohmann::json::array();
        for (std::size_t c = 0; c < m.cards.size(); ++c)
            thesis.push_back({{"card", table.cards[c].name},
                              {"frames_per_second", m.cards[c].framesPerSecond},
                              {"ratio", m.cards[c].ratio},
                              {"ours_over_thesis", m.cards[c].oursOverThesis}});
        rows.push_back({{"name", table.rows[i].name},
                        {"settings", table.rows[i].assignments},
                        {"median_ms", m.medianMs},
                        {"frames_per_second", m.framesPerSecond},
                        {"ratio", m.ratio},
                        {"thesis", std::move(thesis)}});
    }
    json["table"] = {{"number", table.number},
                     {"title", table.title},
                     {"base", table.rows[table.base].name},
                     {"rows", std::move(rows)}};
    return json;
}

std::string toMarkdown(const PaperTable& table, const BenchReport& report)
{
    std::string text = fmt::format("# Mihálik 2008, table {}: {}\n\n", table.number, table.title);
    for (const auto& [key, value] : report.context) text += fmt::format("- {}: {}\n", key, value);
    text += fmt::format("- frames: {} of each configuration, taking turns, after {} to warm up\n\n", report.plan.frames,
                        report.plan.warmUp);
    text += frameTable(table, report);
    text += fmt::format("\nratio: frame rate against {}, the median over frames drawn next to each other; "
                        "beside it the thesis' cards.\n\n",
                        table.rows[table.base].name);
    return text + passTable(table, report);
}

} // namespace tarn

// The thesis' tables from reports made by hand: ratios, and what programs and people are shown.

#include "base/error.h"
#include "measure/paper_tables.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tarn {
namespace {

BenchSeries series(const std::vector<double>& wallMs) { return {.wallMs = wallMs, .cpuMs = wallMs, .triangles = 12}; }

/// Caustics halve the frame rate of every frame, on a machine that becomes ten times slower half-way.
BenchReport causticsReport()
{
    BenchReport report;
    report.context = {{"renderer", "an abacus"}, {"size", "8x6"}};
    report.plan = {.frames = 3, .warmUp = 1};
    report.results.push_back({"caustics on",
                              series({20.0, 20.0, 200.0}),
                              {{"scene", series({4.0})}, {"caustics", series({9.5})}, {"water", series({6.0})}}});
    report.results.push_back(
        {"caustics off", series({10.0, 10.0, 100.0}), {{"scene", series({4.25})}, {"water", series({5.75})}}});
    return report;
}

const PaperTable& causticsTable() { return findPaperTable("2", "--table"); }
const PaperTable& textureTable() { return findPaperTable("3", "--table"); }

std::vector<std::string> lines(const std::string& text)
{
    std::vector<std::string> all;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        all.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return all;
}

bool contains(const std::vector<std::string>& all, const std::string& line)
{
    return std::find(all.begin(), all.end(), line) != all.end();
}

TEST(PaperTables, EachCardHasAFigureForEachRow)
{
    for (const PaperTable& table : paperTables()) {
        EXPECT_LT(table.base, table.rows.size());
        for (const PaperCard& card : table.cards)
            EXPECT_EQ(card.framesPerSecond.size(), table.rows.size()) << card.name;
        for (const PaperRow& row : table.rows) EXPECT_FALSE(row.assignments.empty()) << row.name;
    }
}

TEST(PaperTables, JsonComparesRatiosOfFrameRates)
{
    const nlohmann::json json = toJson(causticsTable(), causticsReport());
    EXPECT_EQ(json["context"]["renderer"], "an abacus");
    EXPECT_EQ(json["configurations"].size(), 2u);
    EXPECT_FALSE(json.contains("ratios")) << "the table has its own, against its base";
    const nlohmann::json& table = json["table"];
    EXPECT_EQ(table["number"], 2);
    EXPECT_EQ(table["base"], "caustics off");
    ASSERT_EQ(table["rows"].size(), 2u);

    const nlohmann::json& on = table["rows"][0];
    EXPECT_EQ(on["name"], "caustics on");
    EXPECT_EQ(on["settings"], nlohmann::json::array({"caustics.enabled=true"}));
    EXPECT_DOUBLE_EQ(on["median_ms"], 20.0);
    EXPECT_DOUBLE_EQ(on["frames_per_second"], 50.0);
    EXPECT_DOUBLE_EQ(on["ratio"], 0.5);
    ASSERT_EQ(on["thesis"].size(), 3u);
    EXPECT_EQ(on["thesis"][0]["card"], "ATI Radeon X800");
    EXPECT_DOUBLE_EQ(on["thesis"][0]["frames_per_second"], 27.0);
    EXPECT_DOUBLE_EQ(on["thesis"][0]["ratio"], 0.36);
    EXPECT_DOUBLE_EQ(on["thesis"][0]["ours_over_thesis"], 0.5 / 0.36);
    EXPECT_NEAR(on["thesis"][1]["ratio"], 0.76, 0.005);
    EXPECT_NEAR(on["thesis"][2]["ratio"], 0.83, 0.005);

    const nlohmann::json& off = table["rows"][1];
    EXPECT_DOUBLE_EQ(off["ratio"], 1.0);
    EXPECT_DOUBLE_EQ(off["thesis"][1]["ours_over_thesis"], 1.0);
}

TEST(PaperTables, RatioIsOfFramesDrawnNextToEachOther)
{
    BenchReport report = causticsReport();
    // The ratio of the medians would be 1.
    report.results[0].frame.wallMs = {8.0, 10.0, 40.0};
    report.results[1].frame.wallMs = {2.0, 10.0, 10.0};
    const nlohmann::json json = toJson(causticsTable(), report);
    EXPECT_DOUBLE_EQ(json["table"]["rows"][0]["ratio"], 0.25);
}

TEST(PaperTables, TextureSizesAreComparedWithTheSmallest)
{
    BenchReport report;
    for (const double ms : {10.0, 12.5, 40.0}) report.results.push_back({"a size", series({ms}), {}});
    const nlohmann::json json = toJson(textureTable(), report);
    const nlohmann::json& rows = json["table"]["rows"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(json["table"]["base"], "256x256");
    EXPECT_EQ(rows[2]["settings"], nlohmann::json::array({"refraction.target_size=1024", "reflection.target_size=1024",
                                                          "caustics.texture_size=1024"}));
    EXPECT_DOUBLE_EQ(rows[0]["ratio"], 1.0);
    EXPECT_DOUBLE_EQ(rows[1]["ratio"], 0.8);
    EXPECT_DOUBLE_EQ(rows[2]["ratio"], 0.25);
    EXPECT_NEAR(rows[2]["thesis"][0]["ratio"], 0.55, 0.005);
    EXPECT_DOUBLE_EQ(rows[2]["thesis"][0]["ours_over_thesis"], 0.25 * 31.0 / 17.0);
}

TEST(PaperTables, MarkdownHasHeadTableAndPasses)
{
    const std::string text = toMarkdown(causticsTable(), causticsReport());
    const std::vector<std::string> all = lines(text);
    EXPECT_EQ(all.front(), "# Mihálik 2008, table 2: caustics on and off");
    for (const char* line : {
             "- renderer: an abacus",
             "- frames: 3 of each configuration, taking turns, after 1 to warm up",
             "|              | median ms |   fps | ratio | ATI Radeon X800 | ours / thesis "
             "| GeForce 7950GT | ours / thesis | GeForce 6800 | ours / thesis |",
             "| caustics on  |     20.00 |  50.0 |  0.50 |    27 fps, 0.36 |          1.39 "
             "|  130 fps, 0.76 |          0.65 | 57 fps, 0.83 |          0.61 |",
             "| caustics off |     10.00 | 100.0 |  1.00 |    75 fps, 1.00 |          1.00 "
             "|  170 fps, 1.00 |          1.00 | 69 fps, 1.00 |          1.00 |",
             "| pass, median ms | caustics on | caustics off |",
             "| --------------- | ----------: | -----------: |",
             "| scene           |        4.00 |         4.25 |",
             "| caustics        |        9.50 |            - |",
             "| water           |        6.00 |         5.75 |",
         })
        EXPECT_TRUE(contains(all, line)) << line << "\nis not in\n" << text;
}

TEST(PaperTables, APassStandsWhereItIsDrawn)
{
    BenchReport report = causticsReport();
    std::swap(report.results[0].passes, report.results[1].passes);
    const std::string text = toMarkdown(causticsTable(), report);
    EXPECT_LT(text.find("| scene "), text.find("| caustics  "));
    EXPECT_LT(text.find("| caustics  "), text.find("| water "));
}

TEST(PaperTables, ReportOfOtherConfigurationsIsRefused)
{
    EXPECT_THROW(toJson(textureTable(), causticsReport()), Error);
    EXPECT_THROW(toMarkdown(textureTable(), causticsReport()), Error);
}

} // namespace
} // namespace tarn

// The table of debug views: names, passes, and that the shaders write what it says they write.
#include "base/files.h"
#include "plan/frame_plan.h"
#include "render/debug_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace tarn {
namespace {

/// "DEBUG_VIEW_PATH_LENGTH" for every view, from the table's own text.
std::string codeOf(DebugView view)
{
    static const char* const codes[] = {
#define DEBUG_VIEW_ROW(view, code, name, writer, display, unit, doc) #code,
#include "shared/debug_views.glsl"
#undef DEBUG_VIEW_ROW
    };
    return codes[static_cast<std::size_t>(view)];
}

/// What a shader's text compares DEBUG_VIEW (or DISPLAY) with.
std::set<std::string> casesIn(const std::string& text, const std::string& macro)
{
    std::set<std::string> cases;
    const std::regex pattern("\\b" + macro + " [!=]= (\\w+)");
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        cases.insert((*match)[1]);
    return cases;
}

std::string shader(const std::string& file) { return readFile(projectRoot() / "shaders/passes" / file); }

TEST(DebugViews, EveryViewHasANameOfItsOwn)
{
    std::set<std::string> names;
    for (const DebugViewInfo& info : debugViews) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_EQ(debugViewFromName(info.name), info.view);
        EXPECT_EQ(debugViewNames[static_cast<std::size_t>(info.view)], std::string(info.name));
        EXPECT_NE(std::string(info.unit), "") << info.name;
        EXPECT_GT(std::string(info.doc).size(), 10u) << info.name;
    }
    EXPECT_EQ(debugViewFromName("final"), DebugView::final);
    EXPECT_EQ(debugViewFromName("path-length"), DebugView::pathLength);
    EXPECT_FALSE(debugViewFromName("path length"));
    EXPECT_FALSE(debugViewFromName(""));
}

TEST(DebugViews, TheirPassesAreThoseOfTheFrame)
{
    std::set<std::string> passes{"all"};
    for (std::size_t i = 0; i < passCount; ++i) passes.insert(passName(static_cast<PassId>(i)));
    for (const DebugViewInfo& info : debugViews) {
        std::istringstream list(passesOf(info.writer));
        for (std::string pass; std::getline(list >> std::ws, pass, ',');)
            EXPECT_EQ(passes.count(pass), 1u) << info.name << ": " << pass;
    }
}

TEST(DebugViews, TheWatersShaderHasACaseForEachOfItsViews)
{
    std::set<std::string> written;
    for (const DebugViewInfo& info : debugViews) {
        EXPECT_EQ(isWaterView(info.view), info.writer == DebugWriter::water);
        written.insert(codeOf(writtenByWater(info.view)));
    }
    EXPECT_EQ(casesIn(shader("water.frag"), "DEBUG_VIEW"), written);
    EXPECT_EQ(writtenByWater(DebugView::normals), DebugView::normals);
    EXPECT_EQ(writtenByWater(DebugView::caustics), DebugView::final);
}

TEST(DebugViews, TheScenesShaderHasACaseForEachOfItsViews)
{
    std::set<std::string> written{codeOf(DebugView::final)};
    for (const DebugViewInfo& info : debugViews)
        if (info.writer == DebugWriter::sceneAndWater) written.insert(codeOf(info.view));
    EXPECT_EQ(casesIn(shader("scene.frag"), "DEBUG_VIEW"), written);
}

/// A number, or a name that the table does not define, would be a view that nobody can ask for.
TEST(DebugViews, ShadersNameNoOthers)
{
    std::set<std::string> codes;
    for (const DebugViewInfo& info : debugViews) codes.insert(codeOf(info.view));
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(projectRoot() / "shaders/passes")) {
        for (const std::string& code : casesIn(readFile(entry.path()), "DEBUG_VIEW"))
            EXPECT_EQ(codes.count(code), 1u) << entry.path() << ": " << code;
        ++files;
    }
    EXPECT_GT(files, 20);
}

TEST(DebugViews, EveryDisplayHasItsColours)
{
    const std::string table = readFile(projectRoot() / "shaders/shared/debug_views.glsl");
    const std::regex pattern("#define (DISPLAY_\\w+) (\\d+)");
    std::set<std::string> names;
    std::set<int> numbers, used;
    for (std::sregex_iterator match(table.begin(), table.end(), pattern), end; match != end; ++match) {
        EXPECT_TRUE(names.insert((*match)[1]).second);
        EXPECT_TRUE(numbers.insert(std::stoi((*match)[2])).second) << (*match)[1];
    }
    EXPECT_EQ(casesIn(shader("present.frag"), "DISPLAY"), names);
    for (const DebugViewInfo& info : debugViews) used.insert(info.display);
    EXPECT_EQ(used, numbers);
}

} // namespace
} // namespace tarn

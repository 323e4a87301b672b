// `tarn compare` on two folders of pictures.
#include "app/commands.h"
#include "base/error.h"
#include "base/files.h"
#include "scene/image.h"

#include "temp_folder.h"

#include <nlohmann/json.hpp>

#include <map>

namespace tarn {
namespace {

namespace fs = std::filesystem;

class CompareFolders : public testing::Test {
protected:
    CompareFolders()
    {
        command_.reference = folder_.path() / "goldens";
        command_.test = folder_.path() / "new";
        makeFolder(command_.reference / "sub");
        makeFolder(command_.test / "sub");
    }

    /// A picture of 20x10 pixels with one of another value.
    void write(const fs::path& file, int value, int one = -1, int channels = 3, int width = 20) const
    {
        Image image{file.string(), width, 10, channels, {}, {}};
        image.bytes.assign(image.size(), static_cast<std::uint8_t>(value));
        if (one >= 0) image.bytes[0] = static_cast<std::uint8_t>(one);
        writeImage(file, image);
    }
    void both(const std::string& name, int expected, int actual, int one = -1) const
    {
        write(command_.reference / name, expected);
        write(command_.test / name, actual, one);
    }
    /// "name": "result", and the error's message or "".
    std::map<std::string, std::string> results()
    {
        command_.json = (folder_.path() / "results.json").string();
        testing::internal::CaptureStdout();
        complaint_.clear();
        try {
            run(command_);
        } catch (const Error& error) {
            complaint_ = error.what();
        }
        printed_ = testing::internal::GetCapturedStdout();
        std::map<std::string, std::string> all;
        const auto json = nlohmann::json::parse(readFile(command_.json));
        for (const auto& picture : json["pictures"]) all[picture["name"]] = picture["result"];
        return all;
    }
    template <typename E> std::string refused() const
    {
        return test::messageOf<E>([&] { run(command_); });
    }

    test::TempFolder folder_;
    CompareCommand command_;
    std::string printed_, complaint_;
};

using Results = std::map<std::string, std::string>;

TEST_F(CompareFolders, EqualPicturesPass)
{
    both("a.png", 100, 100);
    both("sub/b.png", 7, 7);
    write(command_.reference / "sub" / "c.jpg", 50);
    write(command_.test / "sub" / "c.jpg", 50);
    folder_.file("goldens/notes.txt", "no picture");
    EXPECT_EQ(results(), (Results{{"a.png", "good"}, {"sub/b.png", "good"}, {"sub/c.jpg", "good"}}));
    EXPECT_EQ(complaint_, "");
    EXPECT_CONTAINS(printed_, "3 pictures: 3 good");
}

TEST_F(CompareFolders, EveryPictureThatFailsIsTold)
{
    both("different.png", 100, 120);
    both("good.png", 1, 1);
    write(command_.reference / "missing.png", 1);
    write(command_.test / "extra.png", 1);
    write(command_.reference / "sub/wide.png", 1);
    write(command_.test / "sub/wide.png", 1, -1, 3, 21);
    write(command_.reference / "torn.png", 1);
    folder_.file("new/torn.png", "no picture");
    EXPECT_EQ(results(), (Results{{"different.png", "different"},
                                  {"extra.png", "extra"},
                                  {"good.png", "good"},
                                  {"missing.png", "missing"},
                                  {"sub/wide.png", "different"},
                                  {"torn.png", "error"}}));
    EXPECT_CONTAINS(complaint_, "5 of 6 pictures fail");
    EXPECT_CONTAINS(printed_, "expected a picture of 20x10 pixels, got 21x10");
    EXPECT_CONTAINS(printed_, "there is no " + (command_.test / "missing.png").string());
    EXPECT_CONTAINS(printed_, "6 pictures: 1 good, 2 different, 1 missing, 1 extra, 1 error");
}

/// Each limit lets through what the defaults do not, and the other way round.
TEST_F(CompareFolders, LimitsAreThoseGiven)
{
    both("a.png", 100, 104); // within 5, but the mean is over 0.25
    EXPECT_EQ(results()["a.png"], "different");
    command_.tolerance.mean = 4.0;
    EXPECT_EQ(results()["a.png"], "good");
    command_.tolerance.channel = 3;
    EXPECT_EQ(results()["a.png"], "different");
    command_.tolerance.fraction = 1.0;
    EXPECT_EQ(results()["a.png"], "good");
    command_.tolerance.hardLimit = 3;
    EXPECT_EQ(results()["a.png"], "different");
    command_.tolerance.hardFraction = 1.0;
    EXPECT_EQ(results()["a.png"], "good");
    command_.maxFlip = 0.0;
    EXPECT_EQ(results()["a.png"], "different");
    EXPECT_CONTAINS(printed_, "over 0");
    command_.maxFlip = 0.5;
    EXPECT_EQ(results()["a.png"], "good");
}

TEST_F(CompareFolders, OnePixelOfTwoHundredIsOverTheDefaultLimits)
{
    both("a.png", 100, 100, 130);
    EXPECT_EQ(results()["a.png"], "different");
    command_.tolerance.fraction = 0.005;
    EXPECT_EQ(results()["a.png"], "good");
    both("a.png", 100, 100, 145); // over the hard limit
    EXPECT_EQ(results()["a.png"], "different");
}

TEST_F(CompareFolders, LinearPicturesAreComparedAsShown)
{
    const auto linear = [&](const fs::path& file, float value) {
        Image image{file.string(), 4, 3, 3, {}, {}};
        image.floats.assign(image.size(), value);
        writeImage(file, image);
    };
    linear(command_.reference / "a.exr", 4.0f);
    linear(command_.test / "a.exr", 8.0f);
    command_.toneCurve = "linear"; // both are white
    EXPECT_EQ(results()["a.exr"], "good");
    command_.exposure = 0.1;
    EXPECT_EQ(results()["a.exr"], "different");
}

TEST_F(CompareFolders, WritesJUnitAndAReportWithThePicturesThatFail)
{
    both("good.png", 1, 1);
    both("sub/a & <b>.png", 100, 104);
    write(command_.reference / "missing.png", 1);
    write(command_.reference / "clear.png", 9, -1, 4);
    write(command_.test / "clear.png", 200, -1, 4);
    command_.junit = folder_.path() / "junit.xml";
    command_.report = folder_.path() / "report";
    results();
    EXPECT_CONTAINS(complaint_, (command_.report / "index.html").string());
    const std::string junit = readFile(command_.junit);
    EXPECT_CONTAINS(junit, "tests=\"4\" failures=\"3\" errors=\"0\"");
    EXPECT_CONTAINS(junit, "name=\"sub/a &amp; &lt;b&gt;.png\"");
    EXPECT_CONTAINS(junit, "<failure type=\"missing\"");
    const std::string page = readFile(command_.report / "index.html");
    EXPECT_CONTAINS(page, "<strong>good.png</strong>: identical");
    EXPECT_CONTAINS(page, "sub/a &amp; &lt;b&gt;.png");
    EXPECT_CONTAINS(page, "no actual picture");
    std::size_t pictures = 0;
    for (const auto& entry : fs::directory_iterator(command_.report / "pictures")) {
        ++pictures;
        EXPECT_CONTAINS(page, "src=\"pictures/" + entry.path().filename().string() + "\"");
    }
    EXPECT_EQ(pictures, 3u + 3u + 1u);
    EXPECT_EQ(readImage(command_.report / "pictures/3-difference.png").bytes[0], 64); // 16 times 4
    const Image clear = readImage(command_.report / "pictures/1-difference.png");
    EXPECT_EQ(clear.channels, 3) << "a difference that is transparent is not seen";

    // The next run's report takes the place of this one's as a whole.
    write(command_.test / "missing.png", 1);
    both("sub/a & <b>.png", 1, 1);
    both("clear.png", 1, 1);
    results();
    EXPECT_EQ(complaint_, "");
    EXPECT_FALSE(fs::exists(command_.report / "pictures"));
    EXPECT_EQ(readFile(command_.report / "index.html").find("<img"), std::string::npos);
    EXPECT_CONTAINS(readFile(command_.junit), "failures=\"0\"");
}

TEST_F(CompareFolders, OutputsTouchNothingThatIsCompared)
{
    both("a.png", 1, 1);
    for (const fs::path& report : {command_.test, command_.test / "report", command_.reference / "sub" / "..",
                                   folder_.path(), folder_.path() / "x" / ".." / "goldens" / ""}) {
        command_.report = report;
        EXPECT_CONTAINS(refused<UsageError>(), "--report") << report;
    }
    command_.report.clear();
    command_.junit = command_.test / "a.png";
    EXPECT_CONTAINS(refused<UsageError>(), "would be taken for a picture");
    command_.junit = folder_.path() / "report" / "junit.xml";
    command_.report = folder_.path() / "report";
    EXPECT_CONTAINS(refused<UsageError>(), "put it beside that folder");
    command_.junit.clear();
    makeFolder(command_.report);
    folder_.file("report/thesis.txt", "years of work");
    EXPECT_CONTAINS(refused<Error>(), "thesis.txt");
    EXPECT_EQ(readFile(command_.report / "thesis.txt"), "years of work");
    EXPECT_EQ(readImage(command_.test / "a.png").bytes[0], 1);
}

TEST_F(CompareFolders, AFailedRunLeavesTheOldReport)
{
    both("a.png", 1, 1);
    command_.report = folder_.path() / "report";
    results();
    const std::string page = readFile(command_.report / "index.html");
    fs::remove_all(command_.reference / "a.png");
    EXPECT_CONTAINS(refused<Error>(), "holds no pictures");
    EXPECT_EQ(readFile(command_.report / "index.html"), page);
    for (const auto& entry : fs::directory_iterator(folder_.path()))
        EXPECT_NE(entry.path().filename().string().front(), '.') << "left behind: " << entry.path();
}

TEST_F(CompareFolders, WrongUsageIsOneLine)
{
    both("a.png", 1, 1);
    command_.out = folder_.path() / "map.png";
    EXPECT_CONTAINS(refused<UsageError>(), "--report");
    command_.out.clear();
    command_.exposure = 2.0;
    EXPECT_CONTAINS(refused<UsageError>(), "holds none");
    command_.exposure.reset();
    command_.pixelsPerDegree = 30.0;
    EXPECT_CONTAINS(refused<UsageError>(), "--max-flip");
    command_.pixelsPerDegree = defaultPixelsPerDegree;
    command_.tolerance.hardLimit = 4;
    EXPECT_CONTAINS(refused<UsageError>(), "--hard-limit 4");
    command_.tolerance = {};
    command_.junit = folder_.path() / "nowhere" / "junit.xml";
    EXPECT_CONTAINS(refused<Error>(), "nowhere");
    command_.junit.clear();
    command_.test = command_.reference / "";
    EXPECT_CONTAINS(refused<UsageError>(), "the same folder");
    command_.test = command_.reference / "a.png";
    EXPECT_CONTAINS(refused<UsageError>(), "is no folder");
    command_.reference = command_.test;
    command_.report = folder_.path() / "report";
    EXPECT_CONTAINS(refused<UsageError>(), "--report is for two folders");
    command_.report.clear();
    command_.tolerance.mean = 1.0;
    EXPECT_CONTAINS(refused<UsageError>(), "--mean-limit is for two folders");
}

} // namespace
} // namespace tarn

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/progress.h"
#include "temp_folder.h"

#include <thread>

namespace tarn::test {
namespace {

namespace fs = std::filesystem;

std::size_t filesIn(const fs::path& folder)
{
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Files, ReadsBytesAsTheyAre)
{
    const TempFolder folder;
    const std::string bytes("a\0b\r\n\xff", 6);
    EXPECT_EQ(readFile(folder.file("x y.bin", bytes)), bytes);
    EXPECT_EQ(readFile(folder.file("empty", "")), "");
}

TEST(Files, ReadingNamesTheFileAndTheReason)
{
    const TempFolder folder;
    const auto missing = messageOf<Error>([&] { readFile(folder.path() / "none.obj"); });
    EXPECT_CONTAINS(missing, "none.obj: no such file");
    EXPECT_CONTAINS(messageOf<Error>([&] { readFile(folder.path()); }), "is a directory");
}

TEST(Files, MakesFoldersThatAreMissing)
{
    const TempFolder folder;
    makeFolder(folder.path() / "a" / "b");
    makeFolder(folder.path() / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
    folder.file("taken", "");
    EXPECT_CONTAINS(messageOf<Error>([&] { makeFolder(folder.path() / "taken" / "b"); }), "cannot be made");
}

TEST(Files, WritesWholeAndReplaces)
{
    const TempFolder folder;
    const auto file = folder.path() / "out.txt";
    writeFile(file, "first");
    writeFile(file, "second");
    EXPECT_EQ(readFile(file), "second");
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(Files, AFailedWriteLeavesTheOldFileAndNoRest)
{
    const TempFolder folder;
    const auto file = folder.file("out.png", "old");
    fs::path used;
    EXPECT_THROW(writeWhole(file,
                            [&](const fs::path& temporary) {
                                used = temporary;
                                std::ofstream(temporary) << "half";
                                throw Error("no space");
                            }),
                 Error);
    EXPECT_EQ(used.extension(), ".png");
    EXPECT_EQ(used.parent_path(), folder.path());
    EXPECT_EQ(readFile(file), "old");
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(Files, WritingNamesAMissingFolder)
{
    const TempFolder folder;
    EXPECT_CONTAINS(messageOf<Error>([&] { writeFile(folder.path() / "no" / "out.txt", "x"); }), "there is no folder");
    EXPECT_CONTAINS(messageOf<Error>([&] { writeFile(folder.path(), "x"); }), "is a directory");
}

TEST(Files, ProjectRootHoldsShadersAndAssets)
{
    const fs::path root = projectRoot();
    EXPECT_TRUE(fs::is_directory(root / "shaders"));
    EXPECT_TRUE(fs::is_directory(root / "assets"));
}

TEST(Files, ProjectRootFromTheEnvironmentMustBeOne)
{
    const TempFolder folder;
    ASSERT_EQ(::setenv("TARN_DATA", folder.path().c_str(), 1), 0);
    EXPECT_CONTAINS(messageOf<Error>([] { projectRoot(); }), "TARN_DATA=");
    fs::create_directories(folder.path() / "shaders");
    fs::create_directories(folder.path() / "assets");
    EXPECT_EQ(projectRoot(), folder.path());
    ::unsetenv("TARN_DATA");
}

TEST(Log, CaptureCollectsInsteadOfPrinting)
{
    log::Capture outer;
    log::warning("outer {}", 1);
    {
        log::Capture inner;
        log::debug("inner");
        EXPECT_TRUE(inner.contains("inner"));
        EXPECT_FALSE(inner.contains("outer"));
    }
    ASSERT_EQ(outer.messages().size(), 1u);
    EXPECT_EQ(outer.messages()[0].level, log::Level::warning);
    EXPECT_EQ(outer.messages()[0].text, "outer 1");
}

TEST(Progress, TimeLeftFollowsTheRate)
{
    EXPECT_EQ(timeLeft(10.0, 0.5), "10 s");
    EXPECT_EQ(timeLeft(30.0, 0.1), "5 min");
    EXPECT_EQ(timeLeft(36000.0, 0.5), "10 h");
    EXPECT_EQ(timeLeft(5.0, 1.0), "0 s");
}

TEST(Progress, TimeLeftIsSilentWhenItCannotKnow)
{
    EXPECT_EQ(timeLeft(10.0, 0.0), "");
    EXPECT_EQ(timeLeft(0.01, 0.5), "");
    EXPECT_EQ(timeLeft(10.0, std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(Progress, SharedKeepsTheLatestReport)
{
    SharedProgress progress;
    EXPECT_EQ(progress.state().fraction, 0.0);
    std::thread([&] { progress.report(0.25, "half a half"); }).join();
    EXPECT_EQ(progress.state().fraction, 0.25);
    EXPECT_EQ(progress.state().what, "half a half");
    progress.report(7.0, "too much");
    EXPECT_EQ(progress.state().fraction, 1.0);
}

} // namespace
} // namespace tarn::test

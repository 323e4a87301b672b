// What is read from the cache is what was written for this very key, or nothing.
#include "base/disk_cache.h"

#include "base/files.h"
#include "temp_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace tarn::test {
namespace {

namespace fs = std::filesystem;

std::size_t filesIn(const fs::path& folder)
{
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) count += entry.is_regular_file();
    return count;
}

fs::path onlyFileIn(const fs::path& folder)
{
    EXPECT_EQ(filesIn(folder), 1u);
    return fs::directory_iterator(folder)->path();
}

/// Puts it back when the test ends.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name)
    {
        if (const char* old = std::getenv(name)) old_ = old;
        if (value)
            setenv(name, value, 1);
        else
            unsetenv(name);
    }
    ~Variable()
    {
        if (old_)
            setenv(name_, old_->c_str(), 1);
        else
            unsetenv(name_);
    }

private:
    const char* name_;
    std::optional<std::string> old_;
};

TEST(DiskCache, FindsWhatWasWrittenUnderItsKeyOnly)
{
    const TempFolder folder;
    const DiskCache cache(folder.path() / "made when needed", 1 << 20);
    EXPECT_EQ(cache.read("leaf"), std::nullopt);
    const std::string bytes("\0levels\xff", 8);
    cache.write("leaf", bytes);
    cache.write("reed", "");
    EXPECT_EQ(cache.read("leaf"), bytes);
    EXPECT_EQ(cache.read("reed"), "");
    EXPECT_EQ(cache.read("leaf 2"), std::nullopt);
    cache.write("leaf", "others");
    EXPECT_EQ(cache.read("leaf"), "others");
    EXPECT_EQ(DiskCache(folder.path() / "made when needed", 1 << 20).read("leaf"), "others") << "the next start";
}

TEST(DiskCache, TakesNoDamagedFile)
{
    const TempFolder folder;
    const DiskCache cache(folder.path(), 1 << 20);
    cache.write("leaf", "the levels of a leaf");
    const fs::path file = onlyFileIn(folder.path());
    const std::string whole = readFile(file);
    ASSERT_EQ(cache.read("leaf"), "the levels of a leaf");
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string changed = whole;
        changed[i] = static_cast<char>(changed[i] ^ 0x10);
        writeFile(file, changed);
        EXPECT_EQ(cache.read("leaf"), std::nullopt) << "byte " << i << " changed";
        writeFile(file, whole.substr(0, i));
        EXPECT_EQ(cache.read("leaf"), std::nullopt) << "cut at byte " << i;
    }
    writeFile(file, whole + "more");
    EXPECT_EQ(cache.read("leaf"), std::nullopt);
    cache.write("leaf", "again");
    EXPECT_EQ(cache.read("leaf"), "again");
}

TEST(DiskCache, TakesNoFileOfAnotherKey)
{
    const TempFolder folder;
    const DiskCache cache(folder.path(), 1 << 20);
    cache.write("leaf", "a leaf");
    const fs::path leaf = onlyFileIn(folder.path());
    const std::string content = readFile(leaf);
    fs::remove(leaf);
    cache.write("reed", "a reed");
    writeFile(onlyFileIn(folder.path()), content);
    EXPECT_EQ(cache.read("reed"), std::nullopt);
}

TEST(DiskCache, DropsWhatWasLongestUnused)
{
    const TempFolder folder;
    const DiskCache cache(folder.path(), 3500);
    const std::string kilobyte(1000, 'x');
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (const char* key : {"a", "b", "c"}) {
        std::set<fs::path> before;
        for (const auto& entry : fs::directory_iterator(folder.path())) before.insert(entry.path());
        cache.write(key, kilobyte);
        for (const auto& entry : fs::directory_iterator(folder.path()))
            if (!before.contains(entry.path()))
                fs::last_write_time(entry.path(), old + std::chrono::seconds(before.size()));
    }
    EXPECT_EQ(cache.read("a"), kilobyte); // now the latest
    cache.write("d", kilobyte);
    EXPECT_EQ(cache.read("b"), std::nullopt);
    for (const char* key : {"a", "c", "d"}) EXPECT_EQ(cache.read(key), kilobyte) << key;
    cache.write("too large for all of it", std::string(4000, 'y'));
    EXPECT_EQ(filesIn(folder.path()), 3u);
}

TEST(DiskCache, IsSilentWhereItCannotWrite)
{
    const TempFolder folder;
    const fs::path file = folder.file("a file", "no folder");
    const DiskCache inFile(file / "cache", 1 << 20);
    EXPECT_NO_THROW(inFile.write("leaf", "levels"));
    EXPECT_EQ(inFile.read("leaf"), std::nullopt);
    const DiskCache nowhere({}, 1 << 20);
    EXPECT_NO_THROW(nowhere.write("leaf", "levels"));
    EXPECT_EQ(nowhere.read("leaf"), std::nullopt);
}

TEST(DiskCache, LiesWhereTheSystemKeepsCaches)
{
    const Variable home("HOME", "/home/person");
    {
        const Variable cache("XDG_CACHE_HOME", "/var/quick");
        EXPECT_EQ(cacheFolder(), "/var/quick/tarn");
    }
    for (const char* ignored : {static_cast<const char*>(nullptr), "", "relative"}) {
        const Variable cache("XDG_CACHE_HOME", ignored);
        EXPECT_EQ(cacheFolder(), "/home/person/.cache/tarn");
    }
    const Variable cache("XDG_CACHE_HOME", nullptr), homeless("HOME", nullptr);
    EXPECT_EQ(cacheFolder(), "");
}

} // namespace
} // namespace tarn::test

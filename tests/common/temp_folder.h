// A folder of small files for one test, removed with it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace tarn::test {

class TempFolder {
public:
    TempFolder()
    {
        static std::atomic<int> counter{0};
        path_ = std::filesystem::temp_directory_path() /
                ("tarn test " + std::to_string(::getpid()) + "-" + std::to_string(counter++));
        std::filesystem::create_directories(path_);
    }
    ~TempFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Writes a file and returns its path.
    std::filesystem::path file(const std::string& name, std::string_view text) const
    {
        const auto at = path_ / name;
        std::ofstream(at, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
        return at;
    }

private:
    std::filesystem::path path_;
};

/// The message of the exception that `call` throws; a failure, and "", when it throws none of that type.
template <typename Exception, typename Call> std::string messageOf(const Call& call)
{
    try {
        call();
    } catch (const Exception& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line: " << message;
        return message;
    } catch (const std::exception& error) {
        ADD_FAILURE() << "another exception: " << error.what();
        return "";
    }
    ADD_FAILURE() << "nothing was thrown";
    return "";
}

#define EXPECT_CONTAINS(text, part)                                                                                    \
    EXPECT_NE(std::string(text).find(part), std::string::npos) << "in: " << (text) << "\nexpected: " << (part)

} // namespace tarn::test

#include "base/error.h"
#include "base/files.h"
#include "scene/image.h"
#include "temp_folder.h"

#include <cmath>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace tarn::test {
namespace {

/// OpenImageIO 2.4 leaves libpng's error handler by longjmp over a std::string: 31 bytes for each PNG that is
/// cut short. They are not ours to free, and a suppression by name finds no frame to match in libraries built
/// for release.
struct LeaksOfOthers {
#ifdef __SANITIZE_ADDRESS__
    LeaksOfOthers() { __lsan_disable(); }
    ~LeaksOfOthers() { __lsan_enable(); }
#else
    LeaksOfOthers() {}
#endif
};

Image bytesImage(int width, int height, int channels)
{
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    for (std::size_t i = 0; i < image.size(); ++i) image.bytes.push_back(static_cast<std::uint8_t>(i * 37 % 256));
    return image;
}

TEST(Image, PngKeepsBytesForEveryChannelCount)
{
    const TempFolder folder;
    for (const int channels : {1, 3, 4}) {
        const Image written = bytesImage(5, 3, channels);
        writeImage(folder.path() / "x.png", written);
        const Image read = readImage(folder.path() / "x.png");
        EXPECT_EQ(read.width, 5);
        EXPECT_EQ(read.height, 3);
        EXPECT_EQ(read.channels, channels);
        EXPECT_FALSE(read.isFloat());
        EXPECT_EQ(read.bytes, written.bytes) << channels << " channels (alpha must not be multiplied in)";
    }
}

TEST(Image, GreyWithAlphaBecomesRgba)
{
    const TempFolder folder;
    Image image = bytesImage(1, 1, 2);
    image.bytes = {100, 7};
    writeImage(folder.path() / "x.png", image);
    const Image read = readImage(folder.path() / "x.png");
    EXPECT_EQ(read.channels, 4);
    EXPECT_EQ(read.bytes, (std::vector<std::uint8_t>{100, 100, 100, 7}));
}

TEST(Image, ExrKeepsFloatsBeyondOne)
{
    const TempFolder folder;
    Image image;
    image.width = 2;
    image.height = 1;
    image.channels = 3;
    image.floats = {0.0f, 1.5f, 1234.5f, -0.25f, 1e-4f, 3.14159f};
    writeImage(folder.path() / "x.exr", image, {{"tarn:camera", "pier"}});
    const Image read = readImage(folder.path() / "x.exr");
    EXPECT_TRUE(read.isFloat());
    EXPECT_EQ(read.floats, image.floats);
}

TEST(Image, PngOfFloatsIsSrgb)
{
    const TempFolder folder;
    Image image;
    image.width = 4;
    image.height = 1;
    image.channels = 1;
    image.floats = {0.0f, 0.215861f, 1.0f, 9.0f}; // the second: ((128/255 + 0.055) / 1.055)^2.4
    writeImage(folder.path() / "x.png", image);
    EXPECT_EQ(readImage(folder.path() / "x.png").bytes, (std::vector<std::uint8_t>{0, 128, 255, 255}));
    EXPECT_NEAR(srgbDecode(0.5f), 0.214041f, 1e-5f);
}

TEST(Image, SinglePixelIsAPicture)
{
    const TempFolder folder;
    writeImage(folder.path() / "x.png", bytesImage(1, 1, 3));
    EXPECT_EQ(readImage(folder.path() / "x.png").size(), 3u);
}

TEST(Image, BadFilesAreOneLine)
{
    const TempFolder folder;
    const auto problem = [](const std::filesystem::path& file) { return messageOf<Error>([&] { readImage(file); }); };
    EXPECT_CONTAINS(problem(folder.path() / "none.png"), "none.png: no such picture");
    EXPECT_CONTAINS(problem(folder.path()), "is a directory");
    EXPECT_CONTAINS(problem(folder.file("empty.png", "")), "empty.png: ");
    EXPECT_CONTAINS(problem(folder.file("junk.png", "\x01\x02junk, not a picture")), "junk.png: ");
    EXPECT_CONTAINS(problem(folder.file("junk.xyz", "junk")), "junk.xyz: ");

    // The header of a PNG of 0x0 pixels, with its right checksum.
    const std::string zero("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\0\0\0\0\0\x08\x02\0\0\0\xb4\xe9\xeb\x45", 33);
    EXPECT_CONTAINS(problem(folder.file("zero.png", zero)), "zero.png: ");

    writeImage(folder.path() / "whole.png", bytesImage(64, 64, 3));
    const std::string whole = readFile(folder.path() / "whole.png");
    const LeaksOfOthers ignored;
    EXPECT_CONTAINS(problem(folder.file("cut.png", whole.substr(0, whole.size() / 2))), "cut.png: ");
}

TEST(Image, WritingIsWholeOrNothing)
{
    const TempFolder folder;
    EXPECT_CONTAINS(messageOf<Error>([&] { writeImage(folder.path() / "x.png", Image()); }), "empty");
    EXPECT_CONTAINS(messageOf<Error>([&] { writeImage(folder.path() / "x.abc", bytesImage(1, 1, 3)); }), "x.abc");
    EXPECT_CONTAINS(messageOf<Error>([&] { writeImage(folder.path() / "no" / "x.png", bytesImage(1, 1, 3)); }),
                    "no folder");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Image, JpegCanBeWritten)
{
    const TempFolder folder;
    writeImage(folder.path() / "x.jpg", bytesImage(16, 16, 3));
    EXPECT_EQ(readImage(folder.path() / "x.jpg").width, 16);
}

} // namespace
} // namespace tarn::test

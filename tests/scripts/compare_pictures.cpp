// compare_pictures EXPECTED ACTUAL: 0 when they show the same thing, though another driver drew it.
//
// Looser than the goldens: two drivers place the samples of a pixel differently, so silhouettes differ
// everywhere.
#include "measure/image_compare.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::fputs("compare_pictures: error: two pictures are wanted\n", stderr);
        return 2;
    }
    try {
        const tarn::PictureTolerance otherDriver{16, 0.03, 255, 1.0};
        const auto result = tarn::comparePictures(tarn::readImage(argv[1]), tarn::readImage(argv[2]), otherDriver);
        std::printf("%s\n", result.summary().c_str());
        return result.same() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare_pictures: error: %s\n", error.what());
        return 2;
    }
}

// The sums of a picture in the making, and the file that keeps them. Private to src/reference.
#pragma once

#include "base/math.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tarn::reference {

/// Single precision on purpose: what is stored is what was summed, so that going on from a file changes no bit.
struct Accumulation {
    ivec2 size{0};
    int samples = 0;            ///< that every pixel has
    std::vector<vec3> radiance; ///< sums
    std::vector<float> squares; ///< of luminance
    std::vector<float> truncated;

    explicit Accumulation(ivec2 pictureSize);
};

/// @param identity what the sums are of: scene, view, options
void save(const std::filesystem::path& file, const Accumulation& sums, const std::string& identity);

/// Empty sums where there is no such file. Throws Error when it holds something else.
Accumulation load(const std::filesystem::path& file, ivec2 size, const std::string& identity);

} // namespace tarn::reference

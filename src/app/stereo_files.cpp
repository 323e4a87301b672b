#include "app/stereo_files.h"

namespace tarn {

namespace {

template <typename T> std::vector<T> halfRows(const std::vector<T>& values, std::size_t row, std::size_t from)
{
    std::vector<T> half;
    half.reserve(values.size() / 2);
    for (std::size_t begin = 0; begin < values.size(); begin += row) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(begin + from);
        half.insert(half.end(), first, first + static_cast<std::ptrdiff_t>(row / 2));
    }
    return half;
}

} // namespace

std::filesystem::path eyeFile(const std::filesystem::path& file, Eye eye)
{
    return file.parent_path() / (file.stem().string() + "-" + eyeName(eye) + file.extension().string());
}

Image eyeHalf(const Image& both, Eye eye)
{
    const auto row = static_cast<std::size_t>(both.width) * static_cast<std::size_t>(both.channels);
    const std::size_t from = eye == Eye::left ? 0 : row / 2;
    return {both.name,
            both.width / 2,
            both.height,
            both.channels,
            halfRows(both.bytes, row, from),
            halfRows(both.floats, row, from)};
}

} // namespace tarn

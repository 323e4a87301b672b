#include "reference/accumulation.h"

#include "base/error.h"
#include "scene/image.h"

#include <algorithm>
#include <charconv>

namespace tarn::reference {

namespace {
const std::vector<std::string> channels{"sum.R", "sum.G", "sum.B", "squares", "truncated"};
}

Accumulation::Accumulation(ivec2 pictureSize) : size(pictureSize)
{
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    radiance.assign(count, vec3(0.0f));
    squares.assign(count, 0.0f);
    truncated.assign(count, 0.0f);
}

void save(const std::filesystem::path& file, const Accumulation& sums, const std::string& identity)
{
    Image image;
    image.name = file.string();
    image.width = sums.size.x;
    image.height = sums.size.y;
    image.channels = static_cast<int>(channels.size());
    image.floats.reserve(image.size());
    for (std::size_t i = 0; i < sums.radiance.size(); ++i)
        image.floats.insert(image.floats.end(), {sums.radiance[i].x, sums.radiance[i].y, sums.radiance[i].z,
                                                 sums.squares[i], sums.truncated[i]});
    writeImage(file, image, {{"tarn:identity", identity}, {"tarn:samples", std::to_string(sums.samples)}}, channels);
}

Accumulation load(const std::filesystem::path& file, ivec2 size, const std::string& identity)
{
    Accumulation sums(size);
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return sums;
    const NamedImage stored = readNamedImage(file);
    const auto found = stored.metadata.find("tarn:identity");
    const auto samples = stored.metadata.find("tarn:samples");
    if (found == stored.metadata.end() || samples == stored.metadata.end() || found->second != identity ||
        stored.image.channels != static_cast<int>(channels.size()) || stored.image.width != size.x ||
        stored.image.height != size.y)
        throw Error("{}: unfinished work of another picture; finish that one, or delete the file", file.string());
    std::from_chars(samples->second.data(), samples->second.data() + samples->second.size(), sums.samples);
    std::vector<std::size_t> places; // EXR files have an order of their own
    for (const std::string& channel : channels) {
        const auto at = std::find(stored.channelNames.begin(), stored.channelNames.end(), channel);
        if (at == stored.channelNames.end())
            throw Error("{}: has no channel {}; delete the file", file.string(), channel);
        places.push_back(static_cast<std::size_t>(at - stored.channelNames.begin()));
    }
    for (std::size_t i = 0; i < sums.radiance.size(); ++i) {
        const float* values = &stored.image.floats[i * channels.size()];
        sums.radiance[i] = {values[places[0]], values[places[1]], values[places[2]]};
        sums.squares[i] = values[places[3]];
        sums.truncated[i] = values[places[4]];
    }
    return sums;
}

} // namespace tarn::reference

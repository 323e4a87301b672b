#include "reference/picture.h"

#include "base/error.h"
#include "scene/image.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tarn::reference {

namespace {

/// One EXR channel: where its value stands in a picture.
struct Channel {
    std::string name;
    std::function<float(const Picture&, std::size_t)> get;
    std::function<void(Picture&, std::size_t, float)> set;
};

using Vectors = std::vector<vec3> Picture::*;
using Scalars = std::vector<float> Picture::*;

void addVector(std::vector<Channel>& channels, const char* prefix, const char* letters, Vectors member)
{
    for (int i = 0; i < 3; ++i)
        channels.push_back({prefix + std::string(1, letters[i]),
                            [=](const Picture& p, std::size_t pixel) { return (p.*member)[pixel][i]; },
                            [=](Picture& p, std::size_t pixel, float value) { (p.*member)[pixel][i] = value; }});
}

void addScalar(std::vector<Channel>& channels, const char* name, Scalars member)
{
    channels.push_back({name, [=](const Picture& p, std::size_t pixel) { return (p.*member)[pixel]; },
                        [=](Picture& p, std::size_t pixel, float value) { (p.*member)[pixel] = value; }});
}

const std::vector<Channel>& channelList()
{
    static const std::vector<Channel> list = [] {
        std::vector<Channel> channels;
        addVector(channels, "", "RGB", &Picture::radiance);
        addVector(channels, "U.", "XYZ", &Picture::surface);
        addVector(channels, "N.", "XYZ", &Picture::normal);
        addVector(channels, "W.", "XYZ", &Picture::refractionHit);
        addVector(channels, "reflection.", "XYZ", &Picture::reflectionHit);
        addVector(channels, "caustics.", "RGB", &Picture::caustics);
        addScalar(channels, "fresnel", &Picture::fresnel);
        addScalar(channels, "path", &Picture::path);
        channels.push_back({"events",
                            [](const Picture& p, std::size_t pixel) { return static_cast<float>(p.events[pixel]); },
                            [](Picture& p, std::size_t pixel, float value) {
                                p.events[pixel] = static_cast<std::uint32_t>(std::lround(value));
                            }});
        return channels;
    }();
    return list;
}

} // namespace

Picture::Picture(ivec2 pictureSize) : size(pictureSize)
{
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    for (const Vectors member : {&Picture::radiance, &Picture::surface, &Picture::normal, &Picture::refractionHit,
                                 &Picture::reflectionHit, &Picture::caustics})
        (this->*member).assign(count, vec3(0.0f));
    fresnel.assign(count, 0.0f);
    path.assign(count, 0.0f);
    events.assign(count, 0u);
}

void writePicture(const std::filesystem::path& file, const Picture& picture)
{
    if (file.extension() != ".exr") throw Error("{}: a reference is an .exr file", file.string());
    const std::vector<Channel>& channels = channelList();
    Image image;
    image.name = file.string();
    image.width = picture.size.x;
    image.height = picture.size.y;
    image.channels = static_cast<int>(channels.size());
    image.floats.reserve(image.size());
    for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel)
        for (const Channel& channel : channels) image.floats.push_back(channel.get(picture, pixel));
    std::vector<std::string> names;
    for (const Channel& channel : channels) names.push_back(channel.name);
    writeImage(file, image, picture.metadata, names);
}

Picture readPicture(const std::filesystem::path& file)
{
    NamedImage stored = readNamedImage(file);
    Picture picture(ivec2(stored.image.width, stored.image.height));
    picture.metadata = std::move(stored.metadata);
    const auto stride = static_cast<std::size_t>(stored.image.channels);
    for (const Channel& channel : channelList()) {
        const auto found = std::find(stored.channelNames.begin(), stored.channelNames.end(), channel.name);
        if (found == stored.channelNames.end())
            throw Error("{}: has no channel {}; make it with `tarn reference`", file.string(), channel.name);
        const auto index = static_cast<std::size_t>(found - stored.channelNames.begin());
        for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel)
            channel.set(picture, pixel, stored.image.floats[pixel * stride + index]);
    }
    return picture;
}

} // namespace tarn::reference

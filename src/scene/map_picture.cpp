#include "scene/map_picture.h"

#include "base/error.h"
#include "scene/image.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <span>

namespace tarn {

namespace {

constexpr int smallestEdge = 16, largestEdge = 4096; // as heights.map_size
constexpr float mostRadiance = 65504.0f;             // what the passes' half floats hold
constexpr float mostHeight = 1.0e6f;

constexpr std::array bedChannels{"height",     "radiance.R", "radiance.G", "radiance.B",
                                 "response.R", "response.G", "response.B"};
constexpr std::array aboveWaterChannels{"underside", "top",     "seen",    "above.R", "above.G",
                                        "above.B",   "below.R", "below.G", "below.B"};

std::span<const char* const> channelsOf(MapKind kind)
{
    if (kind == MapKind::bed) return bedChannels;
    return aboveWaterChannels;
}

/// The channels before the colours.
std::size_t heightsOf(MapKind kind) { return channelsOf(kind).size() - 6; }

/// Numbers with all their digits, apart by blanks.
std::string textOf(std::initializer_list<float> numbers) { return fmt::format("{}", fmt::join(numbers, " ")); }

/// As many numbers as asked for, or none where the header does not say. Throws Error where it says something else.
std::vector<float> numbersOf(const NamedImage& stored, const char* name, std::size_t count)
{
    const auto found = stored.metadata.find(name);
    if (found == stored.metadata.end()) return {};
    std::vector<float> numbers;
    const char* at = found->second.data();
    const char* const end = at + found->second.size();
    while (at != end) {
        float number = 0.0f;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc() || !std::isfinite(number)) break;
        numbers.push_back(number);
        at = std::find_if(next, end, [](char c) { return c != ' '; });
    }
    if (at != end || numbers.size() != count)
        throw Error(
            "{}: its attribute {} must be {} number{}, not '{}'; write the map anew, or take the attribute away",
            stored.image.name, name, count, count == 1 ? "" : "s", found->second);
    return numbers;
}

void requireMapSize(const Image& image)
{
    if (image.width != image.height)
        throw Error("{}: a map of heights is square, but this picture has {}x{} pixels; scale or cut it", image.name,
                    image.width, image.height);
    const auto edge = static_cast<unsigned>(image.width);
    if (image.width < smallestEdge || image.width > largestEdge || !std::has_single_bit(edge))
        throw Error("{}: the edge of a map of heights is a power of two from {} to {}, not {}; scale it to {}",
                    image.name, smallestEdge, largestEdge, edge,
                    std::clamp(static_cast<int>(std::bit_ceil(edge)), smallestEdge, largestEdge));
}

/// Where each of the map's channels is among the file's.
std::vector<std::size_t> channelPlaces(const NamedImage& stored, MapKind kind)
{
    std::vector<std::size_t> places;
    for (const char* channel : channelsOf(kind)) {
        const auto found = std::find(stored.channelNames.begin(), stored.channelNames.end(), channel);
        if (found == stored.channelNames.end())
            throw Error("{}: has no channel {}; a map '{}' needs {}, as tarn maps writes them", stored.image.name,
                        channel, mapName(kind), fmt::join(channelsOf(kind), ", "));
        places.push_back(static_cast<std::size_t>(found - stored.channelNames.begin()));
    }
    return places;
}

/// @param isColour a radiance or a response; else a height
void requireSound(const Image& image, const char* channel, bool isColour, float value, std::size_t texel)
{
    const bool isSound =
        isColour ? value >= 0.0f && value <= mostRadiance : std::abs(value) <= mostHeight; // NaN is not
    if (isSound) return;
    const auto width = static_cast<std::size_t>(image.width);
    throw Error("{}: {} is {} at pixel ({}, {}); it must be {}", image.name, channel, value, texel % width,
                texel / width,
                isColour ? fmt::format("0 to {}", mostRadiance)
                         : fmt::format("metres, from {} to {}", -mostHeight, mostHeight));
}

void requireStanding(const HeightMapPicture& map)
{
    const auto edge = static_cast<std::size_t>(map.resolution);
    for (std::size_t i = 0; i < edge * edge; ++i) {
        const float underside = map.heights[3 * i], top = map.heights[3 * i + 1];
        if (underside > 0.5f * nothingAboveWater || underside <= top) continue;
        throw Error("{}: underside is {} and top {} at pixel ({}, {}); the top may not be the lower, and where nothing "
                    "stands they are {} and {}",
                    map.file.string(), underside, top, i % edge, i / edge, nothingAboveWater, -nothingAboveWater);
    }
}

void takeValues(HeightMapPicture& map, const NamedImage& stored)
{
    const std::vector<std::size_t> places = channelPlaces(stored, map.kind);
    const std::size_t heights = heightsOf(map.kind);
    const auto stride = static_cast<std::size_t>(stored.image.channels);
    for (std::size_t texel = 0; stride * texel < stored.image.floats.size(); ++texel)
        for (std::size_t channel = 0; channel < places.size(); ++channel) {
            const float value = stored.image.floats[stride * texel + places[channel]];
            const bool isColour = channel >= heights;
            requireSound(stored.image, channelsOf(map.kind)[channel], isColour, value, texel);
            (isColour ? map.colours[channel >= heights + 3 ? 1 : 0] : map.heights).push_back(value);
        }
}

void takeHeader(HeightMapPicture& map, const NamedImage& stored)
{
    if (const auto centre = numbersOf(stored, "tarn:centre", 2); !centre.empty()) map.centre = {centre[0], centre[1]};
    if (const auto extent = numbersOf(stored, "tarn:extent", 2); !extent.empty()) {
        map.extent = {extent[0], extent[1]};
        if (!(map.extent.x > 0.0f && map.extent.y > 0.0f))
            throw Error("{}: its attribute tarn:extent must be more than 0 m, not {} by {}", stored.image.name,
                        extent[0], extent[1]);
    }
    if (map.kind == MapKind::bed) {
        // A bed without a word of what is none is bed everywhere.
        const auto lowest = numbersOf(stored, "tarn:lowest", 1);
        map.lowest = lowest.empty() ? *std::min_element(map.heights.begin(), map.heights.end()) - 1.0f : lowest[0];
    }
    const auto sun = numbersOf(stored, "tarn:sun", 6), sky = numbersOf(stored, "tarn:sky", 3),
               water = numbersOf(stored, "tarn:water", 5);
    if (sun.empty() || sky.empty() || water.empty()) return;
    map.light =
        MapLight{{sun[0], sun[1], sun[2]},      {sun[3], sun[4], sun[5]}, {sky[0], sky[1], sky[2]}, water[0], water[1],
                 {water[2], water[3], water[4]}};
}

/// But for the rounding of another machine's sines and cosines.
bool areSame(const vec3& a, const vec3& b)
{
    return glm::length(a - b) <= 1.0e-3f * std::max(glm::length(a), glm::length(b));
}

bool areSame(float a, float b) { return std::abs(a - b) <= 1.0e-4f; }

} // namespace

const char* mapName(MapKind kind) { return kind == MapKind::bed ? "bed" : "above_water"; }

std::string MapLight::difference(const MapLight& other) const
{
    std::vector<const char*> others;
    if (!areSame(sunDirection, other.sunDirection) || !areSame(sunIrradiance, other.sunIrradiance))
        others.push_back("the sun");
    if (!areSame(skyIrradiance, other.skyIrradiance)) others.push_back("the sky");
    if (!areSame(level, other.level) || !areSame(ior, other.ior) || !areSame(absorption, other.absorption))
        others.push_back("the water");
    return fmt::format("{}", fmt::join(others, " and "));
}

HeightMapPicture readMapPicture(const std::filesystem::path& file, MapKind kind)
{
    const NamedImage stored = readNamedImage(file);
    requireMapSize(stored.image);
    HeightMapPicture map;
    map.kind = kind;
    map.file = file;
    map.resolution = stored.image.width;
    takeValues(map, stored);
    takeHeader(map, stored);
    if (kind == MapKind::aboveWater) requireStanding(map);
    return map;
}

void writeMapPicture(const std::filesystem::path& file, const HeightMapPicture& map,
                     std::map<std::string, std::string> header)
{
    const std::span<const char* const> channels = channelsOf(map.kind);
    const std::size_t heights = heightsOf(map.kind);
    Image image;
    image.name = file.string();
    image.width = image.height = map.resolution;
    image.channels = static_cast<int>(channels.size());
    image.floats.reserve(image.size());
    const auto append = [&image](const std::vector<float>& values, std::size_t texel, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) image.floats.push_back(values[count * texel + i]);
    };
    for (std::size_t texel = 0; heights * texel < map.heights.size(); ++texel) {
        append(map.heights, texel, heights);
        for (const std::vector<float>& colour : map.colours) append(colour, texel, 3);
    }
    header["tarn:map"] = mapName(map.kind);
    header["tarn:centre"] = textOf({map.centre.x, map.centre.y});
    header["tarn:extent"] = textOf({map.extent.x, map.extent.y});
    if (map.kind == MapKind::bed) header["tarn:lowest"] = textOf({map.lowest});
    if (map.light) {
        const vec3 &sun = map.light->sunDirection, &shine = map.light->sunIrradiance, &sky = map.light->skyIrradiance,
                   &k = map.light->absorption;
        header["tarn:sun"] = textOf({sun.x, sun.y, sun.z, shine.x, shine.y, shine.z});
        header["tarn:sky"] = textOf({sky.x, sky.y, sky.z});
        header["tarn:water"] = textOf({map.light->level, map.light->ior, k.x, k.y, k.z});
    }
    writeImage(file, image, header, {channels.begin(), channels.end()});
}

} // namespace tarn

#include "scene/textures.h"

#include "base/error.h"
#include "base/log.h"
#include "scene/sky_picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <mutex>
#include <optional>
#include <thread>

namespace tarn {

namespace {

bool storesLinear(const Image& image)
{
    const auto extension = std::filesystem::path(image.name).extension();
    return extension == ".exr" || extension == ".hdr";
}

/// 16-bit PNG and its like: the eye needs no more than 8 for a reflectance.
void toBytes(Image& image)
{
    image.bytes.resize(image.floats.size());
    std::transform(image.floats.begin(), image.floats.end(), image.bytes.begin(), [](float value) {
        return static_cast<std::uint8_t>(
            std::lround(std::clamp(std::isnan(value) ? 0.0f : value, 0.0f, 1.0f) * 255.0f));
    });
    image.floats.clear();
}

/// One channel of 0..1 values: alpha where there is one, else the mean of the colours.
std::vector<float> oneChannel(const Image& image, bool preferAlpha)
{
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t first = preferAlpha && channels == 4 ? 3 : 0;
    const std::size_t last = first == 3 ? 4 : std::min<std::size_t>(channels, 3);
    std::vector<float> values(image.size() / channels);
    for (std::size_t i = 0; i < values.size(); ++i) {
        float sum = 0.0f;
        for (std::size_t c = first; c < last; ++c)
            sum += image.isFloat() ? image.floats[i * channels + c]
                                   : static_cast<float>(image.bytes[i * channels + c]) / 255.0f;
        values[i] = sum / static_cast<float>(last - first);
    }
    return values;
}

void toAlpha(Image& image)
{
    image.floats = oneChannel(image, true);
    image.channels = 1;
    toBytes(image);
}

/// Heights to tangent-space normals by central differences; the picture repeats at its edges.
void toNormals(Image& image, float bumpScale)
{
    const std::vector<float> heights = oneChannel(image, false);
    const int w = image.width, h = image.height;
    const auto height = [&](int x, int y) {
        return heights[static_cast<std::size_t>((y + h) % h) * static_cast<std::size_t>(w) +
                       static_cast<std::size_t>((x + w) % w)];
    };
    // Heights in texels: black to white is 2 % of the picture's width at a multiplier of 1.
    const float scale = bumpScale * 0.02f * static_cast<float>(w);
    image.channels = 3;
    image.floats.clear();
    image.bytes.resize(image.size());
    auto out = image.bytes.begin();
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            // Rows run downwards but v runs upwards.
            const float du = 0.5f * scale * (height(x + 1, y) - height(x - 1, y));
            const float dv = 0.5f * scale * (height(x, y - 1) - height(x, y + 1));
            const vec3 normal = glm::normalize(vec3(-du, -dv, 1.0f));
            for (int c = 0; c < 3; ++c)
                *out++ = static_cast<std::uint8_t>(std::lround((normal[c] * 0.5f + 0.5f) * 255.0f));
        }
    }
}

void requireUpwardNormals(const Image& image)
{
    if (image.channels < 3) throw Error("{}: a normal map needs three channels", image.name);
    const auto channels = static_cast<std::size_t>(image.channels), width = static_cast<std::size_t>(image.width);
    for (std::size_t i = 1; i < image.size(); i += channels) {
        const float up = image.isFloat() ? image.floats[i] : static_cast<float>(image.bytes[i]) / 255.0f;
        if (up > 0.5f) continue;
        throw Error(
            "{}: the normals of water point up, with a green over 0.5 everywhere, but it is {:.2f} at ({}, {}); a "
            "map whose blue points up needs green and blue exchanged",
            image.name, up, i / channels % width, i / channels / width);
    }
}

void remap(int& index, const std::vector<int>& imageOf)
{
    if (index != noImage) index = imageOf[static_cast<std::size_t>(index)];
}

bool hasTransparency(const Image& image)
{
    if (image.channels != 4) return false;
    for (std::size_t i = 3; i < image.size(); i += 4)
        if (image.isFloat() ? image.floats[i] < 0.98f : image.bytes[i] < 250) return true;
    return false;
}

void finishMaterial(Material& material, const std::vector<Image>& images, const std::vector<int>& imageOf)
{
    const bool wantedDiffuse = material.diffuseMap != noImage;
    for (int* map : {&material.diffuseMap, &material.emissiveMap, &material.alphaMap, &material.normalMap})
        remap(*map, imageOf);
    if (material.normalMap == noImage) material.bumpScale = 0.0f;
    // Exporters write Kd 0 0 0 beside a map_Kd; without the map that would be black.
    if (wantedDiffuse && material.diffuseMap == noImage && material.diffuse == vec3(0.0f))
        material.diffuse = vec3(0.5f);

    const Image* diffuse =
        material.diffuseMap == noImage ? nullptr : &images[static_cast<std::size_t>(material.diffuseMap)];
    if (material.alphaMap != noImage || (diffuse && hasTransparency(*diffuse))) {
        material.alphaTested = true;
        material.twoSided = true;
    }
}

} // namespace

int TextureQueue::request(const std::filesystem::path& file, TextureUse use, const std::string& origin, float bumpScale)
{
    const auto path = file.lexically_normal();
    const auto found = std::find_if(requests_.begin(), requests_.end(), [&](const Request& request) {
        return request.file == path && request.use == use && request.bumpScale == bumpScale;
    });
    if (found != requests_.end()) return static_cast<int>(found - requests_.begin());
    requests_.push_back({path, use, origin, bumpScale});
    return static_cast<int>(requests_.size()) - 1;
}

Image TextureQueue::decode(const Request& request)
{
    Image image = readImage(request.file);
    switch (request.use) {
    case TextureUse::colour:
        if (image.isFloat() && !storesLinear(image)) toBytes(image);
        break;
    case TextureUse::alpha: toAlpha(image); break;
    case TextureUse::normal:
        if (image.channels < 3) throw Error("{}: a normal map needs three channels", image.name);
        break;
    case TextureUse::waterNormal: requireUpwardNormals(image); break;
    case TextureUse::bump: toNormals(image, request.bumpScale); break;
    case TextureUse::sky: skyLayout(image); break;
    }
    return image;
}

void TextureQueue::decodeInto(Scene& scene, Progress* progress)
{
    std::vector<std::optional<Image>> decoded(requests_.size());
    std::vector<std::string> problems(requests_.size());
    std::atomic<std::size_t> next{0};
    std::mutex reporting;
    std::size_t done = 0;

    const auto work = [&] {
        for (std::size_t i = next++; i < requests_.size(); i = next++) {
            try {
                decoded[i] = decode(requests_[i]);
            } catch (const std::exception& error) {
                problems[i] = error.what();
            }
            const std::lock_guard lock(reporting);
            ++done;
            if (progress)
                progress->report(0.5 + 0.5 * static_cast<double>(done) / static_cast<double>(requests_.size()),
                                 "reading " + requests_[i].file.filename().string());
        }
    };
    std::vector<std::future<void>> workers;
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t i = 1; i < std::min(cores, requests_.size()); ++i)
        workers.push_back(std::async(std::launch::async, work));
    work();
    for (auto& worker : workers) worker.get();

    std::vector<int> imageOf(requests_.size(), noImage);
    for (std::size_t i = 0; i < requests_.size(); ++i) {
        if (decoded[i]) {
            imageOf[i] = static_cast<int>(scene.images.size());
            scene.images.push_back(std::move(*decoded[i]));
        } else {
            log::warning("{}: {}; drawn without it", requests_[i].origin, problems[i]);
        }
    }
    for (Material& material : scene.materials) finishMaterial(material, scene.images, imageOf);
    remap(scene.sky.image, imageOf);
    remap(scene.water.normalMap.image, imageOf);
}

} // namespace tarn

// The pictures of a scene: asked for while files are read, then decoded side by side. Private to src/scene.
#pragma once

#include "base/progress.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tarn {

/// What a picture is for decides how it is prepared.
enum class TextureUse {
    colour,      ///< 8 bit sRGB, except for EXR and HDR
    alpha,       ///< one channel: the alpha channel, or the brightness of a picture that has none
    normal,      ///< as stored
    waterNormal, ///< as stored; must point up, which is green
    bump,        ///< heights, made into a normal map
    sky,         ///< as stored; its shape must be one that a sky can have
};

class TextureQueue {
public:
    /// Promises a picture and returns its number; equal requests share one.
    /// @param origin where it is asked for, "lake.mtl:12"
    /// @param bumpScale for TextureUse::bump: black to white is this times 2 % of the picture's width
    int request(const std::filesystem::path& file, TextureUse use, const std::string& origin, float bumpScale = 0.0f);

    /// Decodes all of them on every core into scene.images and turns the promised numbers in materials and
    /// sky into indices. A picture that cannot be read is a warning and leaves noImage.
    void decodeInto(Scene& scene, Progress* progress);

private:
    struct Request {
        std::filesystem::path file;
        TextureUse use;
        std::string origin;
        float bumpScale;
    };
    std::vector<Request> requests_;

    static Image decode(const Request& request);
};

} // namespace tarn

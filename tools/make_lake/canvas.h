// Pictures in linear light, drawn pixel by pixel or stroke by stroke, and written as sRGB PNG or JPEG.
#pragma once

#include "noise.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace tarn::lake {

inline constexpr int textureSize = 1024;

/// Square, linear RGB with coverage. Rows run from top to bottom; u and v of a pixel are from 0 to 1, v
/// upward.
class Canvas {
public:
    /// Tiled canvases let strokes leave on one side and come in on the other; others cut them off.
    enum class Edge { tiled, cut };

    explicit Canvas(int size = textureSize, Edge edge = Edge::tiled)
        : size_(size), edge_(edge), pixels_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), vec4(0.0f))
    {}

    int size() const { return size_; }
    /// Wraps round at the edges, as textures do.
    vec4& at(int x, int y);
    const vec4& at(int x, int y) const;

    /// Sets every pixel from its (u, v).
    void fill(const std::function<vec4(vec2 uv)>& paint);

    /// Draws a tapered round-ended stroke over what is there; positions in pixels, y down.
    void stroke(vec2 a, vec2 b, float radiusA, float radiusB, const vec3& colour);

    /// Paints where `inside(local)` > 0 in the square of `reach` pixels round `centre`; it returns a signed
    /// distance in pixels, positive inside.
    void stamp(vec2 centre, float reach, const std::function<float(vec2 offset)>& inside,
               const std::function<vec3(vec2 offset)>& colour);

    /// Half the size, 2 x 2 averages weighted by coverage.
    Canvas halved() const;

    /// Spreads the colours of covered pixels into uncovered ones, so that filtering shows no dark fringe.
    void bleed();

private:
    int size_;
    Edge edge_;
    std::vector<vec4> pixels_;
};

/// Heights to a tangent-space normal map (x right, y up in the picture, z out), 0 to 1 encoded.
/// `strength` is the height of 1.0 in pixels.
Canvas normalMap(const std::function<float(vec2 uv)>& height, float strength);

/// Scales the colours of a picture so that their mean is the given reflectance.
void setMean(Canvas& canvas, const vec3& mean);

void writeJpeg(const std::filesystem::path& file, const Canvas& canvas, int quality = 90);
/// For data that are no colours: values are written as they are.
void writeJpegData(const std::filesystem::path& file, const Canvas& canvas, int quality = 92);
void writePngWithAlpha(const std::filesystem::path& file, const Canvas& canvas);

} // namespace tarn::lake

// What the reference knows of a view: its radiance, and for each pixel what the water pass has to find out.
//
// Files are EXR with named channels: R, G, B (radiance, linear, the scene's scale), U.X …, N.X …, W.X …,
// reflection.X …, caustics.R …, fresnel, path, events; the header says how they were made.
#pragma once

#include "base/math.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tarn::reference {

/// What happened to the ray through a pixel's centre; the channel `events` holds their sum.
enum Event : std::uint32_t {
    meetsWater = 1,       ///< U, N, fresnel are set
    fromBelow = 2,        ///< the eye's ray met the surface from under water
    refracted = 4,        ///< there is a refracted ray (no total reflection)
    refractionHit = 8,    ///< it met the scene: W and path are set
    reflectionHit = 16,   ///< the reflected ray met the scene: its hit is set
    refractionWater = 32, ///< the refracted ray met the water's surface again before anything else
    reflectionWater = 64, ///< so did the reflected ray
    causticsKnown = 128,  ///< `caustics` is set
};

/// Rows run from top to bottom, like Image. All but radiance are of the ray through the pixel's centre, and zero where
/// `events` does not say that they are set.
struct Picture {
    ivec2 size{0};
    std::vector<vec3> radiance;      ///< mean over the pixel
    std::vector<vec3> surface;       ///< U, world, m
    std::vector<vec3> normal;        ///< N at U, unit, up out of the water
    std::vector<vec3> refractionHit; ///< W, world, m: the first thing of the scene that the refracted ray meets
    std::vector<vec3> reflectionHit; ///< the same for the reflected ray
    std::vector<vec3> caustics;      ///< sunlight on a level area at W (or at the point seen, when the eye is in the
                                     ///< water and meets no surface), relative to the same above the water
    std::vector<float> fresnel;      ///< exact reflectance at U on the eye's side
    std::vector<float> path;         ///< m of water behind U (seen from above: U to W; from below: eye to U)
    std::vector<std::uint32_t> events;
    std::map<std::string, std::string> metadata; ///< "tarn:…"

    Picture() = default;
    explicit Picture(ivec2 pictureSize);
    std::size_t pixels() const { return radiance.size(); }
    bool has(std::size_t pixel, Event event) const { return (events[pixel] & event) != 0; }
};

/// Throws Error as writeImage does; the file must end in .exr.
void writePicture(const std::filesystem::path& file, const Picture& picture);

/// Throws Error naming the file when it is not one that writePicture wrote.
Picture readPicture(const std::filesystem::path& file);

} // namespace tarn::reference

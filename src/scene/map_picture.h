// Maps of heights as pictures: what rays are marched through (src/render/height_maps.h), written out of a scene, or
// given from outside in the place of what the passes would draw.
//
// A map is one EXR file, a square of floats with an edge of 16 to 4096 texels, a power of two, as seen from above: x to
// the right, z downward. Heights are world y in metres, radiance is linear in kcd/m². Its channels:
//
//     bed      height                     the bed's; `lowest` where nothing lies
//              radiance.R, .G, .B         what the bed sends up without the sun: of the sky under the water, of lamps
//              and
//                                         of what shines itself (what stands over the level has its sun in it)
//              response.R, .G, .B         radiance for each unit of the sun's irradiance on a surface that faces it
//     above_water  underside, top             of what stands over the water; 10000 and -10000 where nothing does,
//     underside
//                                         -10000 where it is solid down to the water
//              seen                       height of what is seen from straight below; -10000 where nothing is
//              above.R, .G, .B            radiance seen from straight above, and
//              below.R, .G, .B            from straight below, the sun and its shadows with it
//
// Attributes of the header, all of them text: tarn:centre and tarn:extent (x and z of what it covers, m), tarn:lowest
// (of a bed), and the light that it was made in: tarn:sun, tarn:sky, tarn:water. A picture from elsewhere may lack
// them; the scene file then says what it covers.
#pragma once

#include "base/math.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tarn {

enum class MapKind { bed, aboveWater };

/// "bed" or "above_water": of tables in scene files and of files.
const char* mapName(MapKind kind);

/// Height of an underside where nothing stands; its negative where there is none
/// (shaders/passes/above_water_march.glsl).
inline constexpr float nothingAboveWater = 1.0e4f;

/// What a map's colours depend on: the bed's on the sun's direction alone, in its response, and on the sky.
struct MapLight {
    vec3 sunDirection{0.0f}, sunIrradiance{0.0f};
    vec3 skyIrradiance{0.0f}; ///< mean of the sky's, the first of its coefficients
    float level = 0.0f, ior = 1.0f;
    vec3 absorption{0.0f}; ///< 1/m

    /// What is another in `other`: "the sun", "the sun and the water" …; empty where all is the same but for rounding.
    std::string difference(const MapLight& other) const;
};

struct HeightMapPicture {
    MapKind kind = MapKind::bed;
    std::filesystem::path file; ///< it came from; empty: drawn
    int resolution = 0;         ///< texels
    vec2 centre{0.0f};          ///< x and z, m
    vec2 extent{0.0f};          ///< edge lengths, m; zero where the file does not say
    float lowest = 0.0f;        ///< of a bed: height where nothing lies, under all that does
    std::vector<float> heights; ///< one a texel for a bed, three for what stands over the water; rows run along +z
    std::array<std::vector<float>, 2> colours; ///< three a texel, in the order of the channels above
    std::optional<MapLight> light;             ///< nothing where the file does not say
};

/// Throws Error, with what to do, for a file that is missing or no picture, not square, not of a power of two, too
/// small or too large, without one of the channels, or with values that no map can have (NaN, negative radiance).
HeightMapPicture readMapPicture(const std::filesystem::path& file, MapKind kind);

/// The file appears whole or not at all. `header`: further attributes.
void writeMapPicture(const std::filesystem::path& file, const HeightMapPicture& picture,
                     std::map<std::string, std::string> header = {});

} // namespace tarn

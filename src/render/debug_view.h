// The intermediate pictures of a frame that can be shown in place of the final one.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace tarn {

enum class DebugView {
    final,
    sceneDepth,       ///< metres from the eye along its axis
    refractionColour, ///< the refraction target, as rendered
    refractionDepth,  ///< metres along the refraction camera's axis
    reflection,       ///< the reflection target
    fresnel,          ///< F, 0 to 1
    pathLength,       ///< |A - U|, metres of water
    positionW,        ///< W, world space
    normals,          ///< of scene and water, world space
    caustics,         ///< the caustics texture: irradiance relative to the sun's above the water
    positionU,        ///< U, the water's surface, world space
    positionA,        ///< the point whose picture is taken for W's, world space; alpha 1/2: W has no valid sample
    reflectionHit,    ///< the point that the reflection shows, world space; alpha 2: the direction of what it shows
};
inline constexpr int debugViewCount = 13;

/// As on the command line: "final", "scene-depth", …, in the order of the enumeration.
inline constexpr std::array<const char*, debugViewCount> debugViewNames = {"final",
                                                                           "scene-depth",
                                                                           "refraction",
                                                                           "refraction-depth",
                                                                           "reflection",
                                                                           "fresnel",
                                                                           "path-length",
                                                                           "w-position",
                                                                           "normals",
                                                                           "caustics",
                                                                           "surface-position",
                                                                           "a-position",
                                                                           "reflection-position"};

inline std::optional<DebugView> debugViewFromName(std::string_view name)
{
    for (int i = 0; i < debugViewCount; ++i)
        if (debugViewNames[static_cast<std::size_t>(i)] == name) return static_cast<DebugView>(i);
    return std::nullopt;
}

} // namespace tarn

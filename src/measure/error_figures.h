// What a setting costs in truth, in the words of docs/accuracy.md: the figures of one picture against its reference.
#pragma once

#include <limits>
#include <span>

namespace tarn {

/// NaN stands for "there is nothing to measure": no water pixel, no caustics pass, no refracted ray.
struct ErrorFigures {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    // Refraction hit error, over the water pixels whose refracted ray meets the scene.
    double refractionMedian = none, refractionP95 = none, refractionP99 = none, refractionMax = none; ///< m
    double refractionWrong5cm = none;   ///< share of pixels over 5 cm
    double refractionWrongTexel = none; ///< share over one texel's footprint of the refraction target at the true hit
    double refractionInvalid = none;    ///< share without a valid sample
    double refractionOccluded = none;   ///< share whose true hit the map of heights does not hold: something is over it
    double refractionMissed =
        none; ///< share whose ray was marched past, or did not find, what the map holds in its way
    // Reflection hit error: between the used and the true direction from U to the hit.
    double reflectionMedian = none, reflectionP95 = none, reflectionP99 = none, reflectionMax = none; ///< degrees
    double reflectionSceneP95 =
        none;                      ///< degrees, of the pixels that truly mirror the scene; 180 where they show the sky
    double reflectionWrong = none; ///< share of pixels that show something else than what is mirrored
    double fresnelMean = none, fresnelMax = none; ///< of the reflectance
    double pathMedian = none, pathP99 = none;     ///< m
    double causticsRmse = none;                   ///< relative to the mean of the reference
    double causticsEnergy = none;                 ///< total flux over the reference's
    double flip = none;                           ///< mean, of the display pictures
    double flipWater = none;                      ///< mean over the pixels that show water
    double rmse = none, psnr = none;              ///< linear radiance times exposure; dB
};

/// One figure by name, for tables, CSV and JSON: "refraction.median", "flip" …
struct FigureField {
    const char* name;
    const char* unit;
    const char* doc;
    double ErrorFigures::*member;
    bool smallerIsBetter = true;
};
std::span<const FigureField> errorFigureFields();

/// Mean of each figure over several pictures, leaving out those where it is NaN; the maxima's is the maximum.
ErrorFigures meanFigures(std::span<const ErrorFigures> figures);

} // namespace tarn

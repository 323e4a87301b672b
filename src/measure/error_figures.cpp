#include "measure/error_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace tarn {

std::span<const FigureField> errorFigureFields()
{
    using E = ErrorFigures;
    static constexpr std::array fields{
        FigureField{"refraction.median", "m", "Refraction hit error, median", &E::refractionMedian},
        FigureField{"refraction.p95", "m", "Refraction hit error, 95th percentile", &E::refractionP95},
        FigureField{"refraction.p99", "m", "Refraction hit error, 99th percentile", &E::refractionP99},
        FigureField{"refraction.max", "m", "Refraction hit error, maximum", &E::refractionMax},
        FigureField{"refraction.wrong_5cm", "", "Share of refraction hits over 5 cm wrong", &E::refractionWrong5cm},
        FigureField{"refraction.wrong_texel", "", "Share of refraction hits wrong by more than a texel's footprint",
                    &E::refractionWrongTexel},
        FigureField{"refraction.invalid", "", "Share of pixels without a valid refraction sample",
                    &E::refractionInvalid},
        FigureField{"refraction.occluded", "", "Share of pixels whose true refraction hit is not in the map of heights",
                    &E::refractionOccluded},
        FigureField{"refraction.missed", "",
                    "Share of pixels whose ray was marched past what the map of heights holds in its way",
                    &E::refractionMissed},
        FigureField{"reflection.median", "deg", "Reflection hit error, median", &E::reflectionMedian},
        FigureField{"reflection.p95", "deg", "Reflection hit error, 95th percentile", &E::reflectionP95},
        FigureField{"reflection.p99", "deg", "Reflection hit error, 99th percentile", &E::reflectionP99},
        FigureField{"reflection.max", "deg", "Reflection hit error, maximum", &E::reflectionMax},
        FigureField{"reflection.scene_p95", "deg",
                    "The same of the pixels that truly mirror the scene, 180 where they show sky",
                    &E::reflectionSceneP95},
        FigureField{"reflection.wrong", "",
                    "Share of pixels that mirror sky for scene or the reverse, or a point a tenth "
                    "of the way off",
                    &E::reflectionWrong},
        FigureField{"fresnel.mean", "", "Fresnel error, mean", &E::fresnelMean},
        FigureField{"fresnel.max", "", "Fresnel error, maximum", &E::fresnelMax},
        FigureField{"path.median", "m", "Path-length error, median", &E::pathMedian},
        FigureField{"path.p99", "m", "Path-length error, 99th percentile", &E::pathP99},
        FigureField{"caustics.rmse", "", "Caustic irradiance error, RMSE over the reference's mean", &E::causticsRmse},
        FigureField{"caustics.energy", "", "Flux of the caustics over the reference's", &E::causticsEnergy, false},
        FigureField{"flip", "", "Mean FLIP of the picture", &E::flip},
        FigureField{"flip.water", "", "Mean FLIP over the pixels that show water", &E::flipWater},
        FigureField{"rmse", "", "RMSE of the exposed linear picture", &E::rmse},
        FigureField{"psnr", "dB", "PSNR of the exposed linear picture", &E::psnr, false},
    };
    return fields;
}

ErrorFigures meanFigures(std::span<const ErrorFigures> figures)
{
    ErrorFigures result;
    for (const FigureField& field : errorFigureFields()) {
        const bool isMaximum = std::string_view(field.name).ends_with(".max");
        double sum = 0.0, largest = 0.0;
        std::size_t count = 0;
        for (const ErrorFigures& one : figures) {
            const double value = one.*field.member;
            if (std::isnan(value)) continue;
            sum += value;
            largest = std::max(largest, value);
            ++count;
        }
        if (count > 0) result.*field.member = isMaximum ? largest : sum / static_cast<double>(count);
    }
    return result;
}

} // namespace tarn

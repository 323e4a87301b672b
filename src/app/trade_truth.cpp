#include "app/trade_truth.h"

#include "app/output.h"
#include "app/picture_header.h"
#include "app/reference_view.h"
#include "base/files.h"
#include "base/log.h"
#include "measure/display.h"
#include "measure/flip.h"
#include "measure/picture_error.h"

#include <fmt/format.h>

namespace tarn {

namespace {

/// Of the sun's light under a caustics texture; a pattern of 256² texels then has some sixty in each.
constexpr int mapPhotons = 4'000'000;

WaterBody waterOf(const SceneSetup& sceneSetup)
{
    WaterBody water = sceneSetup.settings.water;
    water.present = water.present && sceneSetup.settings.options.water.enabled;
    return water;
}

std::vector<std::uint8_t> waterMask(const WaterQuantities& used, const reference::Picture& truth)
{
    std::vector<std::uint8_t> mask(truth.pixels());
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = used.isWater[i] != 0 || truth.has(i, reference::meetsWater) ? 1 : 0;
    return mask;
}

bool holds(const vec4& outer, const LevelRect& inner)
{
    const vec2 room = vec2(outer.z, outer.w) - glm::abs(inner.centre - vec2(outer.x, outer.y));
    return glm::all(glm::greaterThanEqual(room, inner.halfExtent));
}

} // namespace

TradeTruth::TradeTruth(const SceneSetup& sceneSetup, const TruthArguments& arguments)
    : sceneSetup_(sceneSetup), arguments_(arguments), water_(waterOf(sceneSetup)),
      tracer_(sceneSetup.scene, water_, sceneSetup.settings.options.water.sunSlopeDeviation)
{
    options_.samples = arguments.samples;
}

const reference::Picture& TradeTruth::picture(const Camera& camera, double time)
{
    if (kept_ && isSameView(kept_->camera, camera) && kept_->time == time) return kept_->picture;
    kept_.reset();
    const reference::ViewRequest view{.camera = camera, .time = time, .size = arguments_.size, .approximations = {}};
    const std::filesystem::path file =
        arguments_.folder.empty() ? std::filesystem::path()
                                  : arguments_.folder / fmt::format("{}-{}.exr", fileNameFrom(camera.name), time);
    std::optional<reference::Picture> picture;
    if (!file.empty() && std::filesystem::exists(file)) {
        picture = reference::readPicture(file);
        const auto& header = picture->metadata;
        const auto is = [&](const char* key, const std::string& value) {
            const auto found = header.find(key);
            return found != header.end() && found->second == value;
        };
        // Another scene, size or number of samples: it is traced again.
        if (!is("tarn:reference", tracer_.identity(view, options_)) ||
            !is("tarn:samples", fmt::format("{}", options_.samples)))
            picture.reset();
    }
    if (!picture) {
        picture = tracer_.render(view, options_);
        if (!file.empty()) {
            picture->metadata.merge(pictureHeader(sceneSetup_, camera, time));
            makeFolder(arguments_.folder);
            reference::writePicture(file, *picture);
        }
    }
    kept_ = Traced{camera, time, std::move(*picture), std::nullopt, {}};
    return kept_->picture;
}

const TrueIrradiance& TradeTruth::lightFor(const CausticsMap& map, double time)
{
    if (kept_->rect && holds(*kept_->rect, map.region.rect)) return kept_->light;
    // A little room: textures of other sizes have their corners elsewhere by some texels.
    const vec2 half = map.region.rect.halfExtent * 1.05f + 0.5f;
    const vec4 rect(map.region.rect.centre, half);
    constexpr double texelsAcross = 1024.0;
    kept_->light =
        tracer_.lightOnBed(time, rect, 2.0 * static_cast<double>(half.x) / texelsAcross, mapPhotons, options_.seed);
    kept_->rect = rect;
    return kept_->light;
}

Image TradeTruth::display(const Camera& camera, double time, const FrameOptions& options)
{
    return displayPicture(picture(camera, time), options);
}

ErrorFigures TradeTruth::judge(const WaterQuantities& used, const Camera& camera, double time,
                               const FrameOptions& options)
{
    const reference::Picture& truth = picture(camera, time);
    ErrorFigures figures = errorFigures(used, truth);
    constexpr int placesAcrossTexel = 2;
    if (used.caustics) addCausticsFigures(figures, *used.caustics, lightFor(*used.caustics, time), placesAcrossTexel);
    const Image map = flipMap(displayPicture(truth, options), used.display);
    figures.flip = meanOf(map);
    figures.flipWater = meanOver(map, waterMask(used, truth));
    const PictureError error = pictureError(exposedPicture(linearPicture(truth), options.exposure),
                                            exposedPicture(used.linear, options.exposure));
    figures.rmse = error.rmse;
    figures.psnr = error.psnr;
    return figures;
}

} // namespace tarn

#include "measure/water_errors.h"

#include "base/error.h"
#include "measure/statistics.h"
#include "optics/optics.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

using glm::dvec3;
using reference::Event;

void requireSameSize(const WaterQuantities& used, const reference::Picture& truth)
{
    if (used.size != truth.size)
        throw Error("a picture of {}x{} pixels cannot be compared with a reference of {}x{}", used.size.x, used.size.y,
                    truth.size.x, truth.size.y);
}

bool showWater(const WaterQuantities& used, const reference::Picture& truth, std::size_t pixel)
{
    return used.isWater[pixel] && truth.has(pixel, Event::meetsWater);
}

double refractionError(const WaterQuantities& used, const reference::Picture& truth, std::size_t pixel)
{
    const dvec3 hit(truth.refractionHit[pixel]);
    return std::max(glm::distance(dvec3(used.position[pixel]), hit), glm::distance(dvec3(used.picture[pixel]), hit));
}

/// Degrees. atan2 keeps its digits at small angles, where acos has lost them.
double angleBetween(const dvec3& a, const dvec3& b)
{
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

double reflectionError(const WaterQuantities& used, const reference::Picture& truth, std::size_t pixel)
{
    const dvec3 surface(truth.surface[pixel]);
    const dvec3 trueDirection = glm::reflect(glm::normalize(surface - dvec3(used.eye)), dvec3(truth.normal[pixel]));
    const dvec3 mirrored(used.mirrored[pixel]);
    return angleBetween(used.mirrorsSky[pixel] ? mirrored : mirrored - surface, trueDirection);
}

std::optional<double> causticsError(const WaterQuantities& used, const reference::Picture& truth, std::size_t pixel)
{
    // Seen from under water, the bed's point is in no channel of the reference.
    if (!used.caustics || !truth.has(pixel, Event::causticsKnown) || !truth.has(pixel, Event::refractionHit) ||
        truth.has(pixel, Event::fromBelow))
        return std::nullopt;
    const CausticsMap& map = *used.caustics;
    const vec2 plane = optics::sunPlane(truth.refractionHit[pixel], map.level, optics::sunShear(map.toSun));
    const std::optional<vec3> light = causticsAt(map, plane);
    if (!light) return std::nullopt;
    const vec3 difference = glm::abs(*light - truth.caustics[pixel]);
    return static_cast<double>(difference.x + difference.y + difference.z) / 3.0;
}

/// Every known error of a kind, over the pixels that a function chooses.
template <typename Choose>
std::vector<double> errorsOf(ErrorKind kind, const WaterQuantities& used, const reference::Picture& truth,
                             const Choose& choose)
{
    std::vector<double> errors;
    for (std::size_t pixel = 0; pixel < used.pixels(); ++pixel)
        if (const auto error = errorAt(kind, used, truth, pixel); error && choose(pixel)) errors.push_back(*error);
    return errors;
}

double mean(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Whether a ray that was marched through the map of heights came more than a texel past the place where it first meets
/// what the map holds, or did not find it. The ray is that of the frame: from U to W.
bool stepsOver(const WaterQuantities& used, std::size_t pixel)
{
    const dvec3 from(used.surface[pixel]), way = dvec3(used.position[pixel]) - from;
    const double marched = glm::length(way);
    if (marched < 1.0e-4) return false; // under the ground from the start
    // The ray is lifted by what single precision may lose of a height, so that one which only grazes an edge counts as
    // passing it.
    constexpr double lift = 1.0e-3;
    const auto met = used.heights->firstMeeting(from + dvec3(0.0, lift, 0.0), way / marched);
    return met && (!used.hasSample[pixel] || marched > *met + static_cast<double>(used.heights->texel()));
}

/// What comes of the map of heights, over the pixels whose rays went through it: those seen from above.
void addMarched(ErrorFigures& figures, const WaterQuantities& used, const reference::Picture& truth)
{
    if (!used.heights) return;
    std::size_t marched = 0, hidden = 0, missed = 0;
    for (std::size_t pixel = 0; pixel < used.pixels(); ++pixel) {
        if (!showWater(used, truth, pixel) || !truth.has(pixel, Event::refractionHit) ||
            truth.has(pixel, Event::fromBelow))
            continue;
        ++marched;
        hidden += !used.heights->holds(truth.refractionHit[pixel], 0.05f);
        missed += stepsOver(used, pixel);
    }
    if (marched == 0) return;
    figures.refractionOccluded = static_cast<double>(hidden) / static_cast<double>(marched);
    figures.refractionMissed = static_cast<double>(missed) / static_cast<double>(marched);
}

void addRefraction(ErrorFigures& figures, const WaterQuantities& used, const reference::Picture& truth)
{
    std::size_t refracted = 0, invalid = 0, over5cm = 0, overTexel = 0;
    const std::vector<double> errors = errorsOf(ErrorKind::refraction, used, truth, [&](std::size_t pixel) {
        const bool valid = used.hasSample[pixel];
        const double error = refractionError(used, truth, pixel);
        ++refracted;
        invalid += !valid;
        over5cm += !valid || error > 0.05;
        overTexel += !valid || error > used.footprint.at(truth.refractionHit[pixel]);
        return valid;
    });
    if (refracted == 0) return;
    const auto fraction = [&](std::size_t count) {
        return static_cast<double>(count) / static_cast<double>(refracted);
    };
    figures.refractionInvalid = fraction(invalid);
    figures.refractionWrong5cm = fraction(over5cm);
    figures.refractionWrongTexel = fraction(overTexel);
    if (errors.empty()) return;
    figures.refractionMedian = percentile(errors, 0.5);
    figures.refractionP95 = percentile(errors, 0.95);
    figures.refractionP99 = percentile(errors, 0.99);
    figures.refractionMax = percentile(errors, 1.0);
}

/// Whether a pixel mirrors another thing than the true ray meets; nothing where that ray meets the water once more.
std::optional<bool> mirrorsOther(const WaterQuantities& used, const reference::Picture& truth, std::size_t pixel)
{
    if (truth.has(pixel, Event::reflectionWater)) return std::nullopt;
    if (used.mirrorsSky[pixel] == truth.has(pixel, Event::reflectionHit)) return true;
    if (used.mirrorsSky[pixel]) return false;
    const dvec3 hit(truth.reflectionHit[pixel]);
    constexpr double nearEnough = 0.1; // of the way: what stands there is the same tree, or one beside it
    return glm::distance(dvec3(used.mirrored[pixel]), hit) >
           nearEnough * glm::distance(hit, dvec3(truth.surface[pixel]));
}

void addReflection(ErrorFigures& figures, const WaterQuantities& used, const reference::Picture& truth)
{
    std::vector<double> ofScene;
    std::size_t known = 0, wrong = 0;
    const std::vector<double> errors = errorsOf(ErrorKind::reflection, used, truth, [&](std::size_t pixel) {
        if (truth.has(pixel, Event::reflectionHit))
            ofScene.push_back(used.mirrorsSky[pixel] ? 180.0 : reflectionError(used, truth, pixel));
        if (const auto other = mirrorsOther(used, truth, pixel)) {
            ++known;
            wrong += *other;
        }
        return true;
    });
    if (errors.empty()) return;
    figures.reflectionMedian = percentile(errors, 0.5);
    figures.reflectionP95 = percentile(errors, 0.95);
    figures.reflectionP99 = percentile(errors, 0.99);
    figures.reflectionMax = percentile(errors, 1.0);
    if (!ofScene.empty()) figures.reflectionSceneP95 = percentile(ofScene, 0.95);
    if (known > 0) figures.reflectionWrong = static_cast<double>(wrong) / static_cast<double>(known);
}

} // namespace

std::optional<double> errorAt(ErrorKind kind, const WaterQuantities& used, const reference::Picture& truth,
                              std::size_t pixel)
{
    if (!showWater(used, truth, pixel)) return std::nullopt;
    const bool hit = truth.has(pixel, Event::refractionHit);
    switch (kind) {
    case ErrorKind::refraction: return hit ? std::optional(refractionError(used, truth, pixel)) : std::nullopt;
    case ErrorKind::reflection:
        return used.reflects ? std::optional(reflectionError(used, truth, pixel)) : std::nullopt;
    case ErrorKind::fresnel:
        return std::abs(static_cast<double>(used.fresnel[pixel]) - static_cast<double>(truth.fresnel[pixel]));
    case ErrorKind::path:
        if (!hit && !truth.has(pixel, Event::fromBelow)) return std::nullopt;
        return std::abs(static_cast<double>(used.waterPath[pixel]) - static_cast<double>(truth.path[pixel]));
    case ErrorKind::caustics: return causticsError(used, truth, pixel);
    }
    return std::nullopt;
}

ErrorFigures errorFigures(const WaterQuantities& used, const reference::Picture& truth)
{
    requireSameSize(used, truth);
    const auto all = [](std::size_t) { return true; };
    ErrorFigures figures;
    addRefraction(figures, used, truth);
    addMarched(figures, used, truth);
    addReflection(figures, used, truth);
    if (const auto errors = errorsOf(ErrorKind::fresnel, used, truth, all); !errors.empty()) {
        figures.fresnelMean = mean(errors);
        figures.fresnelMax = percentile(errors, 1.0);
    }
    if (const auto errors = errorsOf(ErrorKind::path, used, truth, all); !errors.empty()) {
        figures.pathMedian = percentile(errors, 0.5);
        figures.pathP99 = percentile(errors, 0.99);
    }
    return figures;
}

WaterAgreement waterAgreement(const WaterQuantities& used, const reference::Picture& truth)
{
    requireSameSize(used, truth);
    WaterAgreement agreement;
    for (std::size_t pixel = 0; pixel < used.pixels(); ++pixel) {
        const bool inTruth = truth.has(pixel, Event::meetsWater);
        if (used.isWater[pixel])
            ++(inTruth ? agreement.both : agreement.onlyUsed);
        else
            ++(inTruth ? agreement.onlyTruth : agreement.neither);
    }
    return agreement;
}

} // namespace tarn

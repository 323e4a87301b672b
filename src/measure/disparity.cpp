#include "measure/disparity.h"

#include "base/error.h"
#include "measure/statistics.h"
#include "optics/optics.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

EyePoints emptyPoints(const Camera& camera, ivec2 size)
{
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    return {camera, size, std::vector<vec3>(count, vec3(0.0f)), std::vector<std::uint8_t>(count, 0)};
}

/// Where a picture shows a place of the world, in pixels from the centre of its upper left one.
class Projection {
public:
    explicit Projection(const EyePoints& eye) : size_(eye.size)
    {
        const float aspect = static_cast<float>(size_.x) / static_cast<float>(size_.y);
        clipFromWorld_ = glm::dmat4(clipFromView(eye.camera, aspect)) * glm::dmat4(viewFromWorld(eye.camera));
    }
    dvec2 at(const dvec3& position) const
    {
        const dvec4 clip = clipFromWorld_ * dvec4(position, 1.0);
        const dvec2 ndc = dvec2(clip) / std::max(clip.w, 1e-9);
        return {0.5 * (ndc.x + 1.0) * size_.x - 0.5, 0.5 * (1.0 - ndc.y) * size_.y - 0.5};
    }

private:
    ivec2 size_;
    glm::dmat4 clipFromWorld_{1.0};
};

/// Where flat water makes a point seem to be.
dvec3 seenInFlatWater(const dvec3& point, const Camera& camera, const WaterBody& water, ShownBy way)
{
    const auto level = static_cast<double>(water.level);
    if (way == ShownBy::reflection) return {point.x, 2.0 * level - point.y, point.z};
    if (camera.eye.y <= water.level) return point;
    return optics64::flatApparent(dvec3(camera.eye), point, level, static_cast<double>(water.ior));
}

/// A triangle of points that neighbouring pixels show.
struct Patch {
    std::array<dvec3, 3> corners;
    std::array<dvec2, 3> pixels;
};

/// Where in the picture a patch shows a point; nothing when it does not.
std::optional<dvec2> placeWithin(const Patch& patch, const dvec3& point)
{
    const dvec3 &a = patch.corners[0], ab = patch.corners[1] - a, ac = patch.corners[2] - a, ap = point - a;
    const dvec3 normal = glm::cross(ab, ac);
    const double area2 = glm::dot(normal, normal);
    if (area2 <= 0.0) return std::nullopt;
    const double shortest2 = std::min({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(ac - ab, ac - ab)});
    const double off = glm::dot(ap, normal);
    if (off * off > 0.25 * shortest2 * area2) return std::nullopt;
    const double b = glm::dot(glm::cross(ap, ac), normal) / area2, c = glm::dot(glm::cross(ab, ap), normal) / area2;
    // Neighbours that are not in one plane leave a crack between them for what lies off both.
    constexpr double crack = 0.02;
    if (b < -crack || c < -crack || b + c > 1.0 + crack) return std::nullopt;
    return patch.pixels[0] + b * (patch.pixels[1] - patch.pixels[0]) + c * (patch.pixels[2] - patch.pixels[0]);
}

/// Finds where a picture shows a point. Cell (x, y) lies between the centres of pixel (x, y) and the one right below.
class PartnerSearch {
public:
    explicit PartnerSearch(const EyePoints& eye) : eye_(eye), cells_(eye.size - 1)
    {
        for (int y = 0; y < cells_.y; ++y)
            for (int x = 0; x < cells_.x; ++x) boxes_.push_back(boxOf({x, y}));
    }

    /// The nearest place to `expected` of those that show the point, within `reach` pixels of it.
    std::optional<dvec2> find(const dvec3& point, const dvec2& expected, int reach) const
    {
        if (!(glm::length(expected) < 1e6)) return std::nullopt; // not in front of the camera
        const ivec2 centre(glm::floor(expected));
        std::optional<dvec2> best;
        double nearest = reach;
        // A ring of cells around the expected one has no place nearer than its distance less one.
        for (int ring = 0; ring - 1.0 <= nearest; ++ring)
            forRing(centre, ring, [&](ivec2 cell) {
                if (!mayHold(cell, point)) return;
                for (int half = 0; half < 2; ++half) {
                    const std::optional<Patch> patch = patchOf(cell, half);
                    const std::optional<dvec2> position = patch ? placeWithin(*patch, point) : std::nullopt;
                    if (!position || glm::distance(*position, expected) > nearest) continue;
                    best = position;
                    nearest = glm::distance(*position, expected);
                }
            });
        return best;
    }

private:
    struct Box {
        vec3 lower{0.0f}, upper{0.0f};
        bool any = false;
    };

    std::size_t index(ivec2 pixel) const
    {
        return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(eye_.size.x) +
               static_cast<std::size_t>(pixel.x);
    }

    /// Of the points of a cell's corners, grown by how far off them a partner may lie.
    Box boxOf(ivec2 cell) const
    {
        Bounds bounds;
        for (const ivec2 corner : {ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1)})
            if (eye_.isKnown[index(cell + corner)]) bounds.add(eye_.points[index(cell + corner)]);
        if (bounds.empty()) return {};
        const float margin = 0.55f * glm::length(bounds.extent());
        return {bounds.lower - margin, bounds.upper + margin, true};
    }

    bool mayHold(ivec2 cell, const dvec3& point) const
    {
        if (cell.x < 0 || cell.y < 0 || cell.x >= cells_.x || cell.y >= cells_.y) return false;
        const Box& box = boxes_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(cells_.x) +
                                static_cast<std::size_t>(cell.x)];
        const vec3 p(point);
        return box.any && glm::all(glm::greaterThanEqual(p, box.lower)) && glm::all(glm::lessThanEqual(p, box.upper));
    }

    std::optional<Patch> patchOf(ivec2 cell, int half) const
    {
        const ivec2 across = cell + ivec2(1, 0), down = cell + ivec2(0, 1);
        const std::array<ivec2, 3> pixels{half == 0 ? cell : cell + ivec2(1, 1), across, down};
        Patch patch;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!eye_.isKnown[index(pixels[i])]) return std::nullopt;
            patch.corners[i] = dvec3(eye_.points[index(pixels[i])]);
            patch.pixels[i] = dvec2(pixels[i]);
        }
        return patch;
    }

    template <typename Visit> static void forRing(ivec2 centre, int ring, const Visit& visit)
    {
        for (int y = -ring; y <= ring; ++y) {
            const int step = std::abs(y) == ring || ring == 0 ? 1 : 2 * ring;
            for (int x = -ring; x <= ring; x += step) visit(centre + ivec2(x, y));
        }
    }

    const EyePoints& eye_;
    ivec2 cells_;
    std::vector<Box> boxes_;
};

void requireOneSize(const StereoPair& drawn, const StereoPair& truth)
{
    for (const EyePoints* eye : {&drawn.right, &truth.left, &truth.right})
        if (eye->size != drawn.left.size)
            throw Error("pictures of {}x{} and of {}x{} pixels cannot be compared", drawn.left.size.x,
                        drawn.left.size.y, eye->size.x, eye->size.y);
}

double meanOf(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// What is compared, pixel by pixel.
struct Samples {
    std::vector<double> horizontal, signedHorizontal, vertical, truth;
};

void takeFigures(DisparityErrors& errors, const Samples& samples)
{
    errors.compared = samples.horizontal.size();
    if (errors.compared == 0) return;
    errors.median = percentile(samples.horizontal, 0.5);
    errors.p95 = percentile(samples.horizontal, 0.95);
    errors.maximum = percentile(samples.horizontal, 1.0);
    errors.bias = meanOf(samples.signedHorizontal);
    errors.verticalMedian = percentile(samples.vertical, 0.5);
    errors.verticalP95 = percentile(samples.vertical, 0.95);
    errors.trueMedian = percentile(samples.truth, 0.5);
}

} // namespace

EyePoints pointsShown(const WaterQuantities& used, const Camera& camera, ShownBy way)
{
    EyePoints eye = emptyPoints(camera, used.size);
    const bool refracts = way == ShownBy::refraction;
    for (std::size_t pixel = 0; pixel < used.pixels(); ++pixel) {
        if (!used.isWater[pixel] || (refracts ? !used.hasSample[pixel] : used.mirrorsSky[pixel] != 0)) continue;
        eye.points[pixel] = refracts ? used.picture[pixel] : used.mirrored[pixel];
        eye.isKnown[pixel] = 1;
    }
    return eye;
}

EyePoints pointsShown(const reference::Picture& truth, const Camera& camera, ShownBy way)
{
    EyePoints eye = emptyPoints(camera, truth.size);
    const bool refracts = way == ShownBy::refraction;
    for (std::size_t pixel = 0; pixel < truth.pixels(); ++pixel) {
        if (!truth.has(pixel, refracts ? reference::refractionHit : reference::reflectionHit)) continue;
        eye.points[pixel] = refracts ? truth.refractionHit[pixel] : truth.reflectionHit[pixel];
        eye.isKnown[pixel] = 1;
    }
    return eye;
}

std::vector<std::optional<vec2>> disparities(const StereoPair& pair, const WaterBody& water, ShownBy way)
{
    const ivec2 size = pair.left.size;
    const Projection leftProjection(pair.left), rightProjection(pair.right);
    const PartnerSearch search(pair.right);
    const int reach = std::max(size.x / 16, 8);
    std::vector<std::optional<vec2>> result(pair.left.points.size());
    tbb::parallel_for(tbb::blocked_range<int>(0, size.y), [&](const auto& rows) {
        for (int y = rows.begin(); y < rows.end(); ++y) {
            for (int x = 0; x < size.x; ++x) {
                const auto pixel =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
                if (!pair.left.isKnown[pixel]) continue;
                const dvec3 point(pair.left.points[pixel]);
                const dvec2 flat = rightProjection.at(seenInFlatWater(point, pair.right.camera, water, way)) -
                                   leftProjection.at(seenInFlatWater(point, pair.left.camera, water, way));
                const dvec2 here(x, y);
                if (const auto partner = search.find(point, here + flat, reach)) result[pixel] = vec2(*partner - here);
            }
        }
    });
    return result;
}

DisparityErrors disparityErrors(const StereoPair& drawn, const StereoPair& truth, const WaterBody& water, ShownBy way)
{
    requireOneSize(drawn, truth);
    const auto found = disparities(drawn, water, way), exact = disparities(truth, water, way);
    DisparityErrors errors;
    errors.map = {"disparity error", truth.left.size.x, truth.left.size.y, 1, {}, {}};
    errors.map.floats.assign(found.size(), std::numeric_limits<float>::quiet_NaN());
    Samples samples;
    std::size_t alone = 0, aloneInTruth = 0;
    for (std::size_t pixel = 0; pixel < found.size(); ++pixel) {
        if (!drawn.left.isKnown[pixel] || !truth.left.isKnown[pixel]) continue;
        ++errors.pixels;
        alone += !found[pixel];
        aloneInTruth += !exact[pixel];
        if (!found[pixel] || !exact[pixel]) continue;
        const dvec2 error = dvec2(*found[pixel]) - dvec2(*exact[pixel]);
        samples.signedHorizontal.push_back(error.x);
        samples.horizontal.push_back(std::abs(error.x));
        samples.vertical.push_back(std::abs(error.y));
        samples.truth.push_back(static_cast<double>(exact[pixel]->x));
        errors.map.floats[pixel] = static_cast<float>(std::abs(error.x));
    }
    takeFigures(errors, samples);
    if (errors.pixels == 0) return errors;
    errors.alone = static_cast<double>(alone) / static_cast<double>(errors.pixels);
    errors.aloneInTruth = static_cast<double>(aloneInTruth) / static_cast<double>(errors.pixels);
    return errors;
}

} // namespace tarn

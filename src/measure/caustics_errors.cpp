// The caustics' part of water_errors.h.
#include "base/error.h"
#include "measure/water_errors.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

using glm::dvec3;

float fromEdge(const LevelRect& rect, const vec2& plane)
{
    const vec2 inside = rect.halfExtent - glm::abs(plane - rect.centre);
    return std::min(inside.x, inside.y);
}

float texelEdge(const CausticsMap& map)
{
    return 2.0f * map.region.rect.halfExtent.x / static_cast<float>(map.resolution);
}

/// Whether scene.frag takes all of a place's light from the texture: its `fromTexture` is 1.
bool relies(const CausticsMap& map, const vec2& plane)
{
    const float inside = std::min(fromEdge(map.region.rect, plane), fromEdge(map.water, plane));
    return inside >= std::max(map.region.border, 2.0f * texelEdge(map));
}

const vec3& texel(const CausticsMap& map, int x, int y)
{
    const int last = map.resolution - 1;
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, last));
    return map.light[row * static_cast<std::size_t>(map.resolution) + static_cast<std::size_t>(std::clamp(x, 0, last))];
}

/// Mean of the true irradiance over a texel, whose lower corner this is.
std::optional<dvec3> meanOver(const vec2& corner, float edge, const TrueIrradiance& truth, int samples)
{
    dvec3 sum(0.0);
    for (int y = 0; y < samples; ++y) {
        for (int x = 0; x < samples; ++x) {
            const vec2 within = (vec2(x, y) + 0.5f) / static_cast<float>(samples);
            const std::optional<vec3> light = truth(corner + within * edge);
            if (!light) return std::nullopt;
            sum += dvec3(*light);
        }
    }
    return sum / static_cast<double>(samples * samples);
}

double total(const dvec3& v) { return v.x + v.y + v.z; }

} // namespace

std::optional<vec3> causticsAt(const CausticsMap& map, const vec2& plane)
{
    if (map.resolution < 1 || !relies(map, plane)) return std::nullopt;
    const vec2 position = (plane - (map.region.rect.centre - map.region.rect.halfExtent)) / texelEdge(map) - 0.5f;
    const vec2 lower = glm::floor(position), f = position - lower;
    const ivec2 at(lower);
    return glm::mix(glm::mix(texel(map, at.x, at.y), texel(map, at.x + 1, at.y), f.x),
                    glm::mix(texel(map, at.x, at.y + 1), texel(map, at.x + 1, at.y + 1), f.x), f.y);
}

void addCausticsFigures(ErrorFigures& figures, const CausticsMap& used, const TrueIrradiance& truth, int samples)
{
    if (samples < 1) throw Error("caustics need at least one sample a texel, not {}", samples);
    const float edge = texelEdge(used);
    const vec2 corner = used.region.rect.centre - used.region.rect.halfExtent;
    double squares = 0.0, flux = 0.0, trueFlux = 0.0;
    std::size_t values = 0;
    for (int y = 0; y < used.resolution; ++y) {
        for (int x = 0; x < used.resolution; ++x) {
            const vec2 lower = corner + vec2(x, y) * edge;
            if (!relies(used, lower + 0.5f * edge)) continue;
            const std::optional<dvec3> expected = meanOver(lower, edge, truth, samples);
            if (!expected) continue;
            const dvec3 light(texel(used, x, y)), difference = light - *expected;
            squares += glm::dot(difference, difference);
            flux += total(light);
            trueFlux += total(*expected);
            values += 3;
        }
    }
    if (!(trueFlux > 0.0)) return;
    const auto count = static_cast<double>(values);
    figures.causticsRmse = std::sqrt(squares / count) / (trueFlux / count);
    figures.causticsEnergy = flux / trueFlux;
}

} // namespace tarn

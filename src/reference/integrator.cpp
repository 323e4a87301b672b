#include "reference/integrator.h"

#include "reference/target_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tarn::reference {

namespace {

constexpr double farthest = 1.0e5;
/// Rays leave what they met this far away, m: below the size of anything, above single precision at the lake's size.
constexpr double offset = 2.0e-4;
/// A branch that can add less than this share of the pixel is not followed; its share counts as truncated.
constexpr double leastWeight = 1.0e-4;
constexpr double sunAngularRadius = 0.2665 * std::numbers::pi / 180.0;

/// Over what length something in the way makes a shaded place out of one that its texel of the sun map calls lit.
constexpr double contactLength = 0.3;

} // namespace

Integrator::Medium Integrator::mediumAt(const dvec3& point) const
{
    return world_.water && world_.water->contains(point) ? Medium::water : Medium::air;
}

std::optional<Integrator::Meeting> Integrator::nearest(const Ray& ray, Medium medium) const
{
    const auto hit = world_.geometry.intersect(ray, offset, farthest);
    const double limit = hit ? hit->distance : farthest;
    if (world_.water)
        if (const auto distance = world_.water->intersect(ray, 1e-6, limit, medium == Medium::air))
            return Meeting{*distance, std::nullopt};
    if (hit) return Meeting{hit->distance, hit};
    return std::nullopt;
}

vec3 Integrator::radiance(const Ray& ray, double pixelAngle, Random& random, double& truncated) const
{
    return incomingRadiance(ray, mediumAt(ray.origin),
                            {.random = random, .truncated = truncated, .pixelAngle = pixelAngle});
}

vec3 Integrator::skyAlong(const dvec3& direction, const PathState& path) const
{
    if (path.isIndirect) return vec3(0.0f); // the sky's light on surfaces is the spherical harmonics'
    const vec3 d(direction);
    vec3 sky = world_.light.sky.radiance(d);
    if (path.showsSun && world_.light.hasSun() &&
        glm::length(glm::cross(d, world_.light.sunDirection)) < std::sin(sunAngularRadius) &&
        glm::dot(d, world_.light.sunDirection) > 0.0f)
        sky += world_.light.sky.sunDiscRadiance();
    return sky;
}

vec3 Integrator::incomingRadiance(const Ray& ray, Medium medium, PathState path) const
{
    const bool isWet = medium == Medium::water;
    // Water that glows is the passes' model of scattering; light gathered by a surface is only absorbed.
    const vec3 deep = path.isIndirect ? vec3(0.0f) : world_.light.deepRadiance;
    const auto meeting = nearest(ray, medium);
    if (!meeting) return isWet ? deep : skyAlong(ray.direction, path);
    path.length += meeting->distance;
    const vec3 radiance =
        meeting->hit ? shade(ray, *meeting->hit, medium, path) : atSurface(ray, meeting->distance, medium, path);
    if (!isWet) return radiance;
    return optics::radianceThroughWater(radiance, deep, letThrough(meeting->distance, path.fadesLinearly));
}

vec3 Integrator::atSurface(const Ray& ray, double distance, Medium medium, PathState path) const
{
    if (path.events >= world_.options.depth || path.weight < leastWeight) {
        path.truncated += path.weight;
        return vec3(0.0f);
    }
    ++path.events;
    path.fadesLinearly = false;
    const dvec3 U = ray.origin + distance * ray.direction;
    return medium == Medium::air ? fromAbove(ray, U, path) : fromBelow(ray, U, path);
}

vec3 Integrator::glint(const dvec3& U, const dvec3& n, const vec3& toEye) const
{
    const Light& light = world_.light;
    if (!light.hasSun() || glm::dot(n, dvec3(light.sunDirection)) <= 0.0) return vec3(0.0f);
    const vec3 between = toEye + light.sunDirection;
    const float length = glm::length(between);
    if (length < 1e-6f) return vec3(0.0f);
    const float fresnel = optics::fresnelExact(std::max(glm::dot(toEye, between / length), 0.0f), 1.0f / light.ior);
    const vec3 radiance = optics::sunGlint(light.sunIrradiance, fresnel, vec3(n), toEye, light.sunDirection,
                                           world_.sunSlopeDeviation * world_.sunSlopeDeviation);
    if (radiance == vec3(0.0f)) return radiance;
    return world_.geometry.occluded({U, dvec3(light.sunDirection)}, 1e-3, farthest) ? vec3(0.0f) : radiance;
}

/// What water lets through on a path, m.
vec3 Integrator::letThrough(double path, bool fadesLinearly) const
{
    const auto metres = static_cast<float>(path);
    if (fadesLinearly) return vec3(optics::linearAttenuation(metres, world_.approximations.attenuationLength));
    return optics::beerLambert(world_.light.absorption, metres);
}

/// Of the surface seen from above.
double Integrator::reflectance(double cosine) const
{
    const double ior = world_.light.ior;
    const Approximations& rough = world_.approximations;
    if (rough.fresnelTable) return static_cast<double>(rough.fresnelTable->at(static_cast<float>(cosine)).y);
    if (rough.schlickExponent > 0.0f)
        return optics64::fresnelSchlick(cosine, ior, static_cast<double>(rough.schlickExponent));
    return optics64::fresnelExact(cosine, 1.0 / ior);
}

vec3 Integrator::fromAbove(const Ray& ray, const dvec3& U, PathState path) const
{
    const dvec3 n = world_.water->normal(U.x, U.z);
    const double cosine = std::max(-glm::dot(n, ray.direction), 0.0);
    const double ior = world_.light.ior;
    const Approximations& rough = world_.approximations;
    const double F = reflectance(cosine);

    PathState mirrored = path;
    mirrored.weight *= F;
    mirrored.showsSun = false; // the glint is its image
    dvec3 R = world_.water->keptOn(optics64::reflectRay(ray.direction, n), U, true);
    // The frame knows one surface: what is seen in it of further ones is the truth's here.
    const bool isFirst = path.events == 1 && !path.isIndirect;
    Random chance = path.random; // a copy: the path's own numbers stay those of the exact picture
    if (isFirst && rough.reflectionTexels) R = towardsTexel(*rough.reflectionTexels, U, R, chance);
    const vec3 reflected =
        isFirst && rough.reflection ? lookUpMirrored(U, R, mirrored) : incomingRadiance({U, R}, Medium::air, mirrored);

    PathState passed = path;
    passed.weight *= 1.0 - F;
    passed.fadesLinearly = isFirst && rough.attenuationLength > 0.0f;
    dvec3 bent = world_.water->keptOn(optics64::refractRay(ray.direction, n, 1.0 / ior), U, false);
    if (isFirst && rough.refractionTexels) bent = towardsTexel(*rough.refractionTexels, U, bent, chance);
    const vec3 refracted =
        isFirst && rough.refraction ? lookUpBed(U, bent, passed) : incomingRadiance({U, bent}, Medium::water, passed);

    const auto f = static_cast<float>(F);
    vec3 sum = f * reflected + optics::radianceThroughSurface(1.0f - f, world_.light.ior) * refracted;
    if (!path.isIndirect) sum += glint(U, n, vec3(-ray.direction));
    return sum;
}

/// The direction in which what a ray meets would be found, had the place to be the middle of a texel.
dvec3 Integrator::towardsTexel(const TargetTexels& texels, const dvec3& U, const dvec3& direction, Random& chance) const
{
    const TargetPicture picture(texels.camera, world_.geometry, world_.water->level(), world_.light.ior);
    const auto hit = world_.geometry.intersect({U, direction}, offset, farthest);
    const dvec3 W = U + (hit ? hit->distance : texels.camera.farPlane) * direction;
    const dvec3 way = picture.inTexel(W, texels.resolution, chance.next2()) - U;
    const double length = glm::length(way);
    return length > 1e-6 ? way / length : direction;
}

/// Where one of the comparisons that the shadow map's filter makes for a point takes place.
dvec3 Integrator::shadowUv(const ShadowTexels& map, const SurfacePoint& point, const dvec2& chance) const
{
    const double level = world_.water ? world_.water->level() : 0.0;
    const dvec2 shear = optics64::sunShear(dvec3(world_.light.sunDirection));
    const dvec2 plane = optics64::sunPlane(point.position, level, shear);
    const auto cascade = std::find_if(map.cascades.begin(), map.cascades.end(), [&](const ShadowTexels::Cascade& c) {
        return glm::all(glm::lessThanEqual(glm::abs(plane - dvec2(c.rect.x, c.rect.y)), dvec2(c.rect.z, c.rect.w)));
    });
    if (cascade == map.cascades.end()) return point.position;
    const dvec2 centre(cascade->rect.x, cascade->rect.y), half(cascade->rect.z, cascade->rect.w);
    const dvec2 texel = 2.0 * half / static_cast<double>(map.resolution);
    const dvec2 at = (plane - centre + half) / texel;
    // A box of taps - 1 texels with linear edges: its texels by chance of their weights.
    const double box = map.taps - 1;
    const dvec2 middle = glm::floor(at + box * (chance - 0.5)) + 0.5;
    const dvec2 there = centre - half + middle * texel;
    const double y = point.position.y + cascade->bias +
                     glm::dot(optics64::sunPlaneGradient(dvec3(point.geometricNormal), shear), there - plane);
    const dvec2 xz = there + shear * (y - level);
    return {xz.x, y, xz.y};
}

vec3 Integrator::lookUpBed(const dvec3& U, const dvec3& refracted, PathState path) const
{
    const Approximations& rough = world_.approximations;
    const TargetPicture picture(*rough.refraction, world_.geometry, world_.water->level(), world_.light.ior);
    const vec3 deep = world_.light.deepRadiance;
    dvec3 W = U, A = U;
    if (rough.refractionSteps > 0 || rough.planarRefraction) {
        W = picture.search(U, refracted, rough.refractionSteps, rough.planarRefraction, A);
    } else {
        const auto hit = world_.geometry.intersect({U, refracted}, offset, farthest);
        if (!hit) return deep;
        W = U + hit->distance * refracted;
    }
    const TargetPicture::Seen seen = picture.seenAt(W);
    if (rough.refractionSteps == 0 && !rough.planarRefraction) A = seen.point;
    if (!seen.hit) return deep;
    path.length += glm::distance(U, seen.point);
    const bool isWet = seen.point.y < world_.water->level();
    const vec3 bed = shade(seen.ray, *seen.hit, isWet ? Medium::water : Medium::air, path);
    return optics::radianceThroughWater(bed, deep, letThrough(glm::distance(A, U), path.fadesLinearly));
}

vec3 Integrator::lookUpMirrored(const dvec3& U, dvec3 reflected, PathState path) const
{
    reflected.y = std::abs(reflected.y); // as the frame has it: what a wave mirrors of the water is mirrored again
    const Approximations& rough = world_.approximations;
    const TargetPicture picture(*rough.reflection, world_.geometry, world_.water->level(), world_.light.ior);
    const dvec3 W = rough.reflectionSteps > 0 ? picture.searchMirrored(U, reflected, rough.reflectionSteps)
                                              : U + rough.reflectionDistance * reflected;
    const TargetPicture::Seen seen = picture.seenAt(W);
    if (!seen.hit) return skyAlong(seen.ray.direction, path);
    path.length += glm::distance(U, seen.point);
    const bool isWet = seen.point.y < world_.water->level() && world_.water->spans(seen.point.x, seen.point.z);
    return shade(seen.ray, *seen.hit, isWet ? Medium::water : Medium::air, path);
}

vec3 Integrator::fromBelow(const Ray& ray, const dvec3& U, PathState path) const
{
    const dvec3 down = -world_.water->normal(U.x, U.z);
    const double cosine = std::max(-glm::dot(down, ray.direction), 0.0);
    const double ior = world_.light.ior;
    const double F = optics64::fresnelExact(cosine, ior);

    PathState mirrored = path;
    mirrored.weight *= F;
    const dvec3 R = world_.water->keptOn(optics64::reflectRay(ray.direction, down), U, false);
    const vec3 reflected = incomingRadiance({U, R}, Medium::water, mirrored);
    const auto f = static_cast<float>(F);
    if (F >= 1.0) return reflected;

    PathState passed = path;
    passed.weight *= 1.0 - F;
    const dvec3 bent = world_.water->keptOn(optics64::refractRay(ray.direction, down, ior), U, true);
    const vec3 above = incomingRadiance({U, bent}, Medium::air, passed);
    return f * reflected + (1.0f - f) * world_.light.ior * world_.light.ior * above;
}

vec3 Integrator::shade(const Ray& ray, const Hit& hit, Medium medium, PathState path) const
{
    const SurfacePoint point = world_.geometry.surfaceAt(ray, hit);
    const Light& light = world_.light;
    const vec3 toEye(-ray.direction);
    const double footprint = path.length * path.pixelAngle;
    vec3 radiance = point.emitted;
    if (medium == Medium::water) {
        const auto depth = static_cast<float>(world_.water->level() - point.position.y);
        radiance += sunInWater(point, toEye, footprint);
        radiance += point.albedo / pi *
                    optics::skyIrradianceAtDepth(light.skyBelow, light.absorption, std::max(depth, 0.0f), point.normal);
    } else {
        radiance += sunInAir(point, toEye, path);
        radiance += point.albedo / pi * light.skyOn(point.normal);
        if (point.material->alphaTested && point.material->transmission != vec3(0.0f))
            radiance += point.albedo * point.material->transmission / pi * light.skyOn(-point.normal);
    }
    radiance += litByPunctualLights(light, *point.material, point.albedo, vec3(point.position), point.normal, toEye);
    if (path.bounces < world_.options.bounces) radiance += point.albedo * indirect(point, medium, path);
    return radiance;
}

vec3 Integrator::sunInAir(const SurfacePoint& point, const vec3& toEye, PathState& path) const
{
    const Light& light = world_.light;
    if (!light.hasSun()) return vec3(0.0f);
    const vec3 lit = litBy(*point.material, point.albedo, point.normal, toEye, light.sunDirection, light.sunIrradiance);
    if (lit == vec3(0.0f)) return lit;
    const dvec3 sun = glm::normalize(dvec3(light.sunDirection));
    const dvec2 chance = path.random.next2();
    if (const auto& map = world_.approximations.shadows)
        return world_.geometry.occluded({shadowUv(*map, point, chance), sun}, offset, farthest) ? vec3(0.0f) : lit;
    const Across across(sun);
    const dvec2 disc = std::tan(sunAngularRadius) * discFromSquare(chance);
    const dvec3 toSun = glm::normalize(sun + disc.x * across.a + disc.y * across.b);
    const dvec3 outward(point.geometricNormal);
    const dvec3 from = point.position + (glm::dot(outward, toSun) > 0.0 ? offset : -offset) * outward;
    return world_.geometry.occluded({from, toSun}, offset, farthest) ? vec3(0.0f) : lit;
}

std::optional<vec3> Integrator::causticsAt(const dvec3& position, double footprint) const
{
    const auto known = world_.sunMap.relativeIrradiance(position, footprint);
    if (!known || *known == vec3(0.0f)) return known;
    const dvec3 toSun = glm::normalize(dvec3(world_.light.sunDirectionBelow));
    if (world_.geometry.occluded({position, toSun}, 5e-3, contactLength)) return vec3(0.0f);
    return known;
}

vec3 Integrator::sunInWater(const SurfacePoint& point, const vec3& toEye, double footprint) const
{
    const Light& light = world_.light;
    if (!light.hasSun()) return vec3(0.0f);
    vec3 irradiance; // facing the refracted sun
    if (const auto relative = causticsAt(point.position, footprint)) {
        irradiance = *relative * light.sunIrradiance * (light.sunDirection.y / light.sunDirectionBelow.y);
    } else {
        // No photons were asked for here: a flat surface's light, with true shadows.
        const auto depth = static_cast<float>(world_.water->level() - point.position.y);
        irradiance = light.sunBelow * optics::beerLambert(light.absorption, depth / light.sunDirectionBelow.y);
        const dvec3 below(light.sunDirectionBelow);
        const double way = std::max(static_cast<double>(depth), 0.0) / below.y;
        const dvec3 U = point.position + way * below;
        if (world_.geometry.occluded({point.position, below}, 5e-3, std::max(way, 5e-3)) ||
            world_.geometry.occluded({U, dvec3(light.sunDirection)}, 5e-3, farthest))
            return vec3(0.0f);
    }
    return litBy(*point.material, point.albedo, point.normal, toEye, light.sunDirectionBelow, irradiance);
}

/// Light from other surfaces, for one direction in proportion to the cosine: the mean radiance over the hemisphere.
vec3 Integrator::indirect(const SurfacePoint& point, Medium medium, PathState path) const
{
    ++path.bounces;
    path.isIndirect = true;
    path.fadesLinearly = false;
    path.weight *= std::max({point.albedo.x, point.albedo.y, point.albedo.z});
    path.events = 0; // a new start: the limit is that of one path between surfaces
    const dvec3 n(glm::dot(point.normal, point.geometricNormal) > 0.0f ? point.normal : point.geometricNormal);
    const dvec2 disc = discFromSquare(path.random.next2());
    const Across across(n);
    const double up = std::sqrt(std::max(1.0 - disc.x * disc.x - disc.y * disc.y, 0.0));
    const dvec3 direction = glm::normalize(disc.x * across.a + disc.y * across.b + up * n);
    return incomingRadiance({point.position + offset * dvec3(point.geometricNormal), direction}, medium, path);
}

} // namespace tarn::reference

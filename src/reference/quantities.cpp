// Integrator::quantities: what the ray through a pixel's centre meets, without any shading.
#include "reference/integrator.h"

#include <algorithm>

namespace tarn::reference {

namespace {

constexpr double farthest = 1.0e5, offset = 2.0e-4;

void set(Picture& picture, std::size_t pixel, Event event) { picture.events[pixel] |= event; }

} // namespace

void Integrator::lightQueries(const Ray& ray, double pixelAngle, std::vector<LightQuery>& queries) const
{
    struct Step {
        Ray ray;
        Medium medium;
        double length;
        int events;
    };
    constexpr int mostEvents = 3; // what is seen after more of them matters little
    std::vector<Step> open{{ray, mediumAt(ray.origin), 0.0, 0}};
    while (!open.empty()) {
        const Step step = open.back();
        open.pop_back();
        const auto meeting = nearest(step.ray, step.medium);
        if (!meeting) continue;
        const double length = step.length + meeting->distance;
        const dvec3 point = step.ray.origin + meeting->distance * step.ray.direction;
        if (meeting->hit) {
            if (step.medium == Medium::water) queries.push_back({point, length * pixelAngle});
            continue;
        }
        if (step.events >= mostEvents) continue;
        const bool isWet = step.medium == Medium::water;
        const dvec3 up = world_.water->normal(point.x, point.z);
        const dvec3 n = isWet ? -up : up;
        const double ior = world_.light.ior;
        const dvec3 mirrored = world_.water->keptOn(optics64::reflectRay(step.ray.direction, n), point, !isWet);
        open.push_back({{point, mirrored}, step.medium, length, step.events + 1});
        const dvec3 bent = optics64::refractRay(step.ray.direction, n, isWet ? ior : 1.0 / ior);
        if (bent == dvec3(0.0)) continue;
        open.push_back({{point, world_.water->keptOn(bent, point, isWet)},
                        isWet ? Medium::air : Medium::water,
                        length,
                        step.events + 1});
    }
}

void Integrator::quantities(const Ray& ray, double pixelAngle, Picture& picture, std::size_t pixel) const
{
    const Medium medium = mediumAt(ray.origin);
    const auto meeting = nearest(ray, medium);
    const auto keepCaustics = [&](const dvec3& position, double length) {
        const auto light = causticsAt(position, length * pixelAngle);
        if (!light) return;
        picture.caustics[pixel] = *light;
        set(picture, pixel, causticsKnown);
    };
    if (!meeting) return;
    if (meeting->hit) {
        if (medium == Medium::water) {
            picture.path[pixel] = static_cast<float>(meeting->distance);
            keepCaustics(ray.origin + meeting->distance * ray.direction, meeting->distance);
        }
        return;
    }

    const bool isBelow = medium == Medium::water;
    const dvec3 U = ray.origin + meeting->distance * ray.direction;
    const dvec3 up = world_.water->normal(U.x, U.z);
    const dvec3 n = isBelow ? -up : up; // on the eye's side
    const double eta = isBelow ? static_cast<double>(world_.light.ior) : 1.0 / static_cast<double>(world_.light.ior);
    const double cosine = std::max(-glm::dot(n, ray.direction), 0.0);
    picture.surface[pixel] = vec3(U);
    picture.normal[pixel] = vec3(up);
    picture.fresnel[pixel] = static_cast<float>(optics64::fresnelExact(cosine, eta));
    set(picture, pixel, meetsWater);
    if (isBelow) {
        set(picture, pixel, Event::fromBelow);
        picture.path[pixel] = static_cast<float>(meeting->distance);
    }

    // The hits behind further surfaces are not followed: the first thing met is what a lookup must find.
    const auto follow = [&](const dvec3& direction, Medium inside, Event hitEvent, Event waterEvent,
                            std::vector<vec3>& plane) -> double {
        const Ray onward{U, direction};
        const auto hit = world_.geometry.intersect(onward, offset, farthest);
        const double limit = hit ? hit->distance : farthest;
        if (world_.water->intersect(onward, 1e-3, limit, inside == Medium::air)) set(picture, pixel, waterEvent);
        if (!hit) return -1.0;
        plane[pixel] = vec3(U + hit->distance * direction);
        set(picture, pixel, hitEvent);
        return hit->distance;
    };

    const auto keptOn = [&](const dvec3& direction, bool above) { return world_.water->keptOn(direction, U, above); };
    follow(keptOn(optics64::reflectRay(ray.direction, n), !isBelow), medium, Event::reflectionHit, reflectionWater,
           picture.reflectionHit);
    const dvec3 refracted = optics64::refractRay(ray.direction, n, eta);
    if (refracted == dvec3(0.0)) return;
    const dvec3 bent = keptOn(refracted, isBelow);
    set(picture, pixel, Event::refracted);
    const double distance = follow(bent, isBelow ? Medium::air : Medium::water, Event::refractionHit, refractionWater,
                                   picture.refractionHit);
    if (distance < 0.0 || isBelow) return;
    picture.path[pixel] = static_cast<float>(distance);
    keepCaustics(U + distance * bent, meeting->distance + distance);
}

} // namespace tarn::reference

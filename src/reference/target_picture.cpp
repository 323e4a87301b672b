#include "reference/target_picture.h"

#include "optics/optics.h"

#include <algorithm>

namespace tarn::reference {

TargetPicture::TargetPicture(const TargetCamera& camera, const Geometry& geometry, double level, double ior)
    : camera_(camera), geometry_(geometry), worldFromView_(glm::inverse(camera.viewFromWorld)), eye_(worldFromView_[3]),
      level_(level), ior_(ior)
{}

/// The nearest that the camera draws of a part of a ray.
TargetPicture::Seen TargetPicture::seenFrom(const Ray& ray, double from, double to) const
{
    const double side = camera_.keepsAbove ? 1.0 : -1.0;
    const double start = side * (ray.origin.y - camera_.clipLevel), rate = side * ray.direction.y;
    // Drawn is where start + t · rate >= 0.
    if (std::abs(rate) > 1e-12)
        (rate > 0.0 ? from : to) = rate > 0.0 ? std::max(from, -start / rate) : std::min(to, -start / rate);
    else if (start < 0.0)
        to = from;
    Seen seen{ray, std::nullopt, dvec3(0.0)};
    if (from < to) seen.hit = geometry_.intersect(ray, from, to);
    if (seen.hit) seen.point = ray.origin + seen.hit->distance * ray.direction;
    return seen;
}

/// @param direction of a straight line from the camera's eye, unit, world
TargetPicture::Seen TargetPicture::alongLine(const dvec3& direction) const
{
    const double depthRate = -(dmat3(camera_.viewFromWorld) * direction).z;
    const double farthest = camera_.farPlane / std::max(depthRate, 1e-6);
    const double inAir = camera_.throughFlatWater && direction.y < 0.0 ? (level_ - eye_.y) / direction.y : farthest;
    Seen seen = seenFrom({eye_, direction}, 0.0, std::min(inAir, farthest));
    if (seen.hit) return seen;
    seen.point = eye_ + farthest * direction;
    if (inAir >= farthest) return seen;
    const Ray bent{eye_ + inAir * direction, optics64::refractRay(direction, dvec3(0.0, 1.0, 0.0), 1.0 / ior_)};
    seen = seenFrom(bent, 0.0, farthest - inAir);
    if (!seen.hit) seen.point = bent.origin + (farthest - inAir) * bent.direction;
    return seen;
}

TargetPicture::Seen TargetPicture::seenAt(const dvec3& position) const
{
    const dvec3 p = inView(camera_.throughFlatWater ? optics64::flatApparent(eye_, position, level_, ior_) : position);
    const dvec2 tangent = glm::clamp(dvec2(p) / std::max(-p.z, 1e-6), -camera_.tangents, camera_.tangents);
    return alongLine(glm::normalize(dmat3(worldFromView_) * dvec3(tangent, -1.0)));
}

dvec3 TargetPicture::inTexel(const dvec3& position, int resolution, const dvec2& chance) const
{
    const bool isFlat = camera_.throughFlatWater;
    const dvec3 p = inView(isFlat ? optics64::flatApparent(eye_, position, level_, ior_) : position);
    if (p.z > -1e-6) return position;
    const dvec2 texel = 2.0 * camera_.tangents / static_cast<double>(resolution); // tangents across one
    const dvec2 at = dvec2(p) / -p.z / texel;
    // Texels' middles lie at halves, since an even number of them lies about the picture's middle.
    const dvec2 middle = glm::floor(at - 0.5 + chance) + 0.5;
    const dvec3 seen = inWorld(dvec3(middle * texel, -1.0) * -p.z);
    return isFlat ? optics64::flatTrue(eye_, seen, level_, ior_) : seen;
}

dvec3 TargetPicture::search(const dvec3& U, const dvec3& direction, int steps, bool planar, dvec3& A) const
{
    if (camera_.throughFlatWater) {
        // In world space, with the height as the coordinate that says what is behind.
        const auto swapped = [](const dvec3& v) { return dvec3(v.x, v.z, v.y); };
        const auto seen = [&](const dvec3& w) { return swapped(seenAt(swapped(w)).point); };
        const dvec3 u = swapped(U), r = swapped(direction);
        dvec3 a = seen(u);
        dvec3 hit = u;
        if (a.z < u.z) {
            if (planar) {
                hit = optics64::planarIntersection(u, r, a);
            } else {
                auto state = optics64::intersectionBegin(u, r, a);
                for (int i = 1; i < steps; ++i) state = optics64::intersectionStepSampled(state, seen(state.W));
                state = optics64::intersectionEnd(state);
                hit = state.best;
                a = state.bestA;
            }
        }
        A = swapped(a);
        return swapped(hit);
    }
    dvec3 u = inView(U);
    u.z = std::min(u.z, -1.0e-3);
    const dvec3 r = glm::normalize(dmat3(camera_.viewFromWorld) * direction);
    const auto depthAt = [&](const dvec3& w) { return inView(seenAt(inWorld(w)).point).z; };
    const dvec3 first = optics64::depthSample(u, depthAt(u));
    auto state = optics64::intersectionBegin(u, r, first);
    if (planar) {
        state.best = optics64::planarIntersection(u, r, first);
        state.bestA = first;
    } else {
        for (int i = 1; i < steps; ++i) state = optics64::intersectionStep(state, depthAt(state.W));
    }
    A = inWorld(state.bestA);
    return inWorld(state.best);
}

dvec3 TargetPicture::searchMirrored(const dvec3& U, const dvec3& direction, int steps) const
{
    dvec3 u = inView(U);
    u.z = std::min(u.z, -1.0e-3);
    const dmat3 rotation(camera_.viewFromWorld);
    const dvec3 r = glm::normalize(rotation * direction);
    auto choice = optics64::mirrorBegin(u, r, rotation * dvec3(0.0, 1.0, 0.0));
    const auto look = [&](const dvec3& w) {
        const Seen seen = seenAt(inWorld(w));
        const dvec3 shown = optics64::depthSample(w, inView(seen.point).z);
        choice = optics64::mirrorConsider(choice, w, shown, !seen.hit);
        return shown;
    };
    auto state = optics64::intersectionBegin(u, r, look(u));
    for (int i = 1; i < steps; ++i) state = optics64::intersectionStepSampled(state, look(state.W));
    return inWorld(optics64::mirrorChosen(choice));
}

} // namespace tarn::reference

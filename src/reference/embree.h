// Embree's two generations behind one face. Private to src/reference.
#pragma once

#include "base/math.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

namespace tarn::reference {

struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, DeviceRelease>;
using RayScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, SceneRelease>;

/// @param id given to filter functions as RTCRayN_id
inline RTCRay makeRay(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax, unsigned id)
{
    RTCRay ray{};
    ray.org_x = static_cast<float>(origin.x);
    ray.org_y = static_cast<float>(origin.y);
    ray.org_z = static_cast<float>(origin.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = static_cast<float>(tMin);
    ray.tfar = static_cast<float>(tMax);
    ray.mask = ~0u;
    ray.id = id;
    return ray;
}

inline void intersect(RTCScene scene, RTCRayHit& hit)
{
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &hit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &hit);
#endif
}

inline bool occluded(RTCScene scene, RTCRay ray)
{
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
    return ray.tfar < 0.0f;
}

} // namespace tarn::reference

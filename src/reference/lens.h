// The rays through a picture's pixels. Private to src/reference.
#pragma once

#include "base/math.h"
#include "reference/geometry.h"
#include "scene/camera.h"

#include <cmath>

namespace tarn::reference {

/// Rays through a picture, pixel (0, 0) at its upper left.
class Lens {
public:
    Lens(const Camera& camera, ivec2 size) : eye_(camera.eye), size_(size)
    {
        forward_ = glm::normalize(dvec3(camera.target) - eye_);
        right_ = glm::normalize(glm::cross(forward_, dvec3(camera.up)));
        up_ = glm::cross(right_, forward_);
        tangent_ = std::tan(0.5 * static_cast<double>(camera.verticalFov));
        shift_ = static_cast<double>(camera.lensShift);
    }
    /// @param x,y in pixels from the upper left corner
    Ray through(double x, double y) const
    {
        const double scale = 2.0 * tangent_ / size_.y;
        const double u = (x - 0.5 * size_.x) * scale + shift_, v = (0.5 * size_.y - y) * scale;
        return {eye_, glm::normalize(forward_ + u * right_ + v * up_)};
    }
    double pixelAngle() const { return 2.0 * tangent_ / size_.y; }

private:
    dvec3 eye_, forward_, right_, up_;
    ivec2 size_;
    double tangent_, shift_;
};

} // namespace tarn::reference

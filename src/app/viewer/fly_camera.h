// The camera that a person flies. Pure: keys, mouse and seconds in, a Camera out, the same path at any frame
// rate.
#pragma once

#include "base/math.h"
#include "scene/camera.h"

namespace tarn {

class FlyCamera {
public:
    explicit FlyCamera(const Camera& start) { jumpTo(start); }

    /// Takes over the view exactly; the speed stays.
    void jumpTo(const Camera& camera);

    /// @param pixels how far the mouse went, to the right and down   @param windowHeight pixels
    /// One window height turns by one vertical field of view, so that the picture moves as far as the mouse
    /// does.
    void look(vec2 pixels, float windowHeight);

    /// @param direction x to the right, y up, z forward; longer than 1 counts as 1
    void move(const vec3& direction, bool fast, double seconds);

    /// One notch of the wheel changes the speed by a fifth.
    void changeSpeed(double notches);

    const Camera& camera() const { return camera_; }
    float speed() const { return speed_; } ///< m/s

private:
    void faceTowards(float yaw, float pitch);

    Camera camera_;
    float speed_ = 4.0f;
};

} // namespace tarn

// Gives memory back to the system while the picture of a scene comes into being: the texels of its images once they are
// on the graphics card, and what loading and compiling have freed.
//
//     SpareMemory spare(sceneSetup.scene);     // whose texels nothing else needs: no reference is traced, nothing
//     uploaded again while (…) {
//         picture.take();
//         spare.release(picture);
//     }
#pragma once

#include "scene/scene.h"

#include <chrono>
#include <cstddef>

namespace tarn {

class LivePicture;

class SpareMemory {
public:
    /// @param scene that the picture shows; must outlive this
    explicit SpareMemory(Scene& scene) : scene_(scene) {}

    /// In the thread that owns the scene. Seldom does more than to look at the clock.
    void release(const LivePicture& picture);

private:
    void trim();

    Scene& scene_;
    bool hasTexels_ = true;
    bool isBuilt_ = false; ///< all programs were, once
    std::chrono::steady_clock::time_point lastLook_{};
    std::size_t lastResident_ = 0; ///< bytes, after the last time that something was given back
};

} // namespace tarn

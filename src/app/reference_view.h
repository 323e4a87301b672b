// A reference picture as the program meets it: the view that it shows, and what it looks like on the screen.
#pragma once

#include "app/scene_setup.h"
#include "plan/options.h"
#include "reference/picture.h"
#include "scene/image.h"
#include "scene/scene.h"

#include <filesystem>

namespace tarn {

/// Where a reference was seen from, and when.
struct ReferenceView {
    Camera camera;
    double time = 0.0; ///< s
};

/// From the picture's header (app/picture_header.h). What the header leaves out, the near and the far plane, is that of
/// the scene's camera of the same name, or of its first. Throws Error naming the file when the header does not say.
ReferenceView referenceView(const reference::Picture& picture, const Scene& scene, const std::filesystem::path& file);

/// Whether two cameras show the same, but for rounding: a thousandth of a pixel's worth.
bool isSameView(const Camera& a, const Camera& b);

/// Throws Error naming the file and what differs when the picture shows another scene or other water than a frame of
/// these settings would; says so in a warning when its header does not tell.
void requireSameScene(const reference::Picture& picture, const SceneSetup& sceneSetup,
                      const std::filesystem::path& file);

/// Its radiance: three float channels.
Image linearPicture(const reference::Picture& picture);

/// As the viewer would show it: 8-bit sRGB, three channels.
Image displayPicture(const reference::Picture& picture, const FrameOptions& options);

} // namespace tarn

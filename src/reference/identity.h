// What a reference is of, as text: so that sums of paths are only added to their own, and a frame is only judged by the
// truth of its own scene.
#pragma once

#include "reference/reference.h"
#include "scene/scene.h"

#include <string>

namespace tarn::reference {

/// Every part of a scene that a picture of it depends on, with a hash of its content, not of names:
/// "geometry 1f…; materials …; textures …; sky …; sun …; lights …; water …; waves …". The same on every machine whose
/// floats are those of IEEE 754.
/// @param body the water, which settings may change
std::string sceneIdentity(const Scene& scene, const WaterBody& body);

/// Where the picture is seen from, and how it is traced; follows a scene's identity.
std::string viewIdentity(const ViewRequest& view, const ReferenceOptions& options, float sunSlopeDeviation);

/// The parts of two scenes' identities that differ: "the geometry and the sky"; empty where none does.
std::string sceneDifference(const std::string& a, const std::string& b);

} // namespace tarn::reference

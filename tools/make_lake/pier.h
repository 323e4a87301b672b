// The pier on its posts, and the boat that is moored to it.
#pragma once

#include "lake_shape.h"
#include "mesh.h"

namespace tarn::lake {

/// Where the pier stands: from its root on the shore straight out over the water.
struct PierSite {
    vec2 root, direction;
    float length = 19.0f, width = 1.7f, deck = 0.62f; ///< deck: height of its upper face
    vec2 at(float along, float across) const
    {
        return root + along * direction + across * vec2(-direction.y, direction.x);
    }
};
PierSite pierSite(const LakeShape& shape);
Mesh makePier(const LakeShape& shape, const PierSite& site, Random random);

/// worldFromBoat: the bow along +x, the keel's middle at the origin, the water line at y = 0.
mat4 boatPlace(const PierSite& site);
Mesh makeBoat(Random random);
/// From the bow to a post of the pier, world space.
Mesh makeRope(const PierSite& site);

} // namespace tarn::lake

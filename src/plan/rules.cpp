#include "plan/rules.h"

namespace tarn {

namespace {

// In the order of RuleId. target_bounds is proved in plan/water_bounds.h. Not among them:
// - The horizon as a bound of the reflection target, though no look goes below it: there is nothing but sky there, and
// the
//   lake's target takes as long with it as without.
// - Bounds of the refraction target: what lies under the level is drawn there and nothing else, so that beside a pond
// it is
//   empty already; and near the critical angle a little slope moves what is seen through the surface without bound.
// - Leaving out waves shorter than a pixel: the point U and the refracted ray are those of all waves. Where that moves
// what
//   is seen by a quarter of a pixel, an edge changes by a quarter of its contrast, which is no bound in 1/255. And it
//   would save little: seen from 300 m above, without the four shortest of its twenty waves, which are as many as keep
//   within a quarter of a pixel, the lake's water pass takes 4 to 6 % less time and the frame about 1 %.
constexpr std::array<Rule, ruleCount> table{{
    {"cull_chunks",
     "Leave out the chunks of the scene that a pass's own frustum, clip plane or the water's surface hides", nullptr,
     1},
    {"cull_hidden",
     "Leave out blocks of the water that the scene hides: those hidden in the last frame are asked for in the depth of "
     "this one",
     nullptr, 1},
    {"water_out_of_view", "No targets, surface or glow while the water is outside the view's frustum", nullptr, 1},
    {"water_hidden",
     "No targets, surface or highlight while the scene hides the water: asked in the depth of the same frame", nullptr,
     1},
    {"only_sky_mirrored", "No reflection target while its camera sees nothing but sky: the sky is looked up itself",
     "the sky's change between the ray and the texel that the target would show for it, its border included", 3},
    {"no_bed", "No refraction target while its camera sees nothing: the water's colour stands for it", nullptr, 1},
    {"bed_too_deep", "No refraction target while too much water absorbs all that its camera sees",
     "half of 1/255, for a bed whose sunlight waves gather up to 16-fold", 1},
    {"nothing_for_caustics", "No caustics while no camera sees anything under water", nullptr, 1},
    {"glow_out_of_view", "No glow while no wave can mirror its lobe into the view", "half of 1/255", 1},
    {"target_bounds",
     "Draw of the reflection target only the part in which the water on the screen can look anything up", nullptr, 1},
    {"keep_maps",
     "Keep the sun's maps, the maps of heights and the caustics while what they are made of stays as it is", nullptr,
     1},
    {"keep_targets", "Keep the refraction and reflection targets while what they are made of stays as it is", nullptr,
     1},
    {"keep_frame", "Keep the whole picture while nothing changes", nullptr, 1},
}};

} // namespace

const Rule& rule(RuleId id) { return table[static_cast<std::size_t>(id)]; }

} // namespace tarn

#include "reference/options.h"

namespace tarn::reference {

void visit(FieldVisitor& v, ReferenceOptions& o)
{
    v.enter("reference", "The ray-traced reference");
    v.field({"samples", "Paths through each pixel", "", 1, 65536}, o.samples);
    v.field({"depth", "Meetings with the water's surface that a path follows", "", 1, 16}, o.depth);
    v.field({"bounces", "Diffuse reflections of light between bed, objects and surface; 0 as the passes model it", "",
             0, 64},
            o.bounces);
    v.field({"photons", "Photons of the sun traced through the surface", "", 10'000, 2'000'000'000}, o.photons);
    v.field({"seed", "Of all random numbers; the same seed gives the same picture", "", 0, 2'000'000'000}, o.seed);
    v.leave();
}

} // namespace tarn::reference

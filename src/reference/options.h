// What the reference may be asked for. Private options of `tarn reference` and of everything that calls it.
#pragma once

#include "base/fields.h"

namespace tarn::reference {

struct ReferenceOptions {
    int samples = 64;         ///< paths through each pixel
    int depth = 4;            ///< meetings with the water's surface that a path follows
    int bounces = 0;          ///< diffuse reflections of light between bed, objects and surface
    int photons = 10'000'000; ///< that the sun's light through the surface is traced with
    int seed = 1;
};

/// Group "reference".
void visit(FieldVisitor& visitor, ReferenceOptions& options);

} // namespace tarn::reference

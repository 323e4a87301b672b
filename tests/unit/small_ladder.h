// A ladder over the program's defaults: msaa 4, taps 2, photons 256, facets three.
#pragma once

#include "plan/ladder.h"

namespace tarn::test {

inline Ladder smallLadder()
{
    return {"A pond",
            "320x240",
            "a machine",
            {{"frame.msaa", "4"}, {"sunlight.taps", "2"}, {"caustics.photons", "256"}, {"reflection.facets", "three"}},
            {{{}, 1.0, 100.0, 0.10, 0.04},
             {{{"frame.msaa", "1"}}, 0.7, 70.0, 0.12, 0.04},
             {{{"frame.msaa", "1"}, {"reflection.facets", "one"}}, 0.5, 50.0, 0.14, 0.05},
             {{{"frame.msaa", "1"}, {"reflection.facets", "one"}, {"caustics.photons", "64"}}, 0.25, 25.0, 0.2, 0.1}}};
}

} // namespace tarn::test

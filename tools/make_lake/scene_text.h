// lake.toml: light, water with its waves, models, where they stand, cameras.
#pragma once

#include "views.h"
#include "woods.h"

namespace tarn::lake {

struct SceneParts {
    std::vector<std::string> placedModels; ///< OBJ files in world space, without extension
    std::vector<Species> const* species = nullptr;
    std::vector<StandingTree> const* trees = nullptr;
    std::vector<View> const* views = nullptr;
    mat4 worldFromBoat{1.0f};
    float boatTurn = 0.0f; ///< about y, radians
};

std::string sceneText(const SceneParts& parts, Random random);

} // namespace tarn::lake

// The named cameras. The generator knows them too: it keeps branches out of their faces.
#pragma once

#include "lake_shape.h"

#include <string>
#include <vector>

namespace tarn::lake {

struct View {
    std::string name;
    vec3 eye, target;
    float fov;                ///< vertical, degrees
    float clearing = 14.0f;   ///< no tree in the picture's cone nearer than this, m
    float lowClearing = 3.0f; ///< the same for grass, reeds and stones
};

std::vector<View> views(const LakeShape& shape);

/// True when something of `radius` at p would stand in a view's way.
enum class Growth { tall, low };
bool blocksView(const std::vector<View>& all, vec2 p, float radius, Growth growth = Growth::tall);

} // namespace tarn::lake

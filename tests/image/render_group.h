// The first half of a picture test: draw the cases of a group and leave the pictures for the second half.
#pragma once

#include "image/cases.h"

namespace tarn::imagetest {

/// Renders every case of the group under OSMesa, always checking for NaN, infinite and negative values and
/// for OpenGL errors. A case that fails leaves its reason in place of a picture. Throws Error when nothing
/// can be rendered at all: the scene does not load, a shader does not compile.
void renderGroup(const Group& group);

} // namespace tarn::imagetest

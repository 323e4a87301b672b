// The machine that something was measured on.
#pragma once

#include <string>

namespace tarn {

/// The processor, which is the renderer as well where OpenGL is drawn in software: "…, 8 threads".
std::string machineText();

} // namespace tarn

// tarn bench --interactive.
#pragma once

#include "app/commands.h"

namespace tarn {

/// Plays a recorded flight past the scene's cameras at its real speed, and tells how long frames took and
/// inputs waited.
void runInteractive(const BenchCommand& command);

} // namespace tarn

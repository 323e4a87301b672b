// tarn render --error: where the water is wrong, as a picture, and by how much, as a table.
#pragma once

#include "app/command_line.h"

namespace tarn {

/// Renders the view of command.reference and writes the map of command.error to command.out. Throws Error when the
/// reference cannot be read or has another size than the one asked for.
void renderError(const RenderCommand& command);

} // namespace tarn

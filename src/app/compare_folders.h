// tarn compare of two folders: every picture of one with that of the same name in the other, as continuous integration
// needs it of any renderer (docs/ci.md).
#pragma once

#include "app/command_line.h"

namespace tarn {

/// Prints what differs and writes the files that were asked for. Throws Error when a picture fails, is missing or is
/// one too many, and then all is written too; UsageError when the arguments do not fit together.
void compareFolders(const CompareCommand& command);

} // namespace tarn

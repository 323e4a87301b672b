// The table of options as a page in Markdown: what docs/options.md is.
#pragma once

#include "base/fields.h"

#include <string>
#include <vector>

namespace tarn {

/// One heading and table for each group, and one for the debug views. @param rows those of a group together   @param
/// tree that they are from
std::string optionsPage(const std::vector<FieldRow>& rows, const FieldTree& tree);

} // namespace tarn

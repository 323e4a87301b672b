// That the frame plan leaves out nothing that can be seen: every case drawn with the plan and without it.
#pragma once

#include "image/cases.h"

namespace tarn::imagetest {

/// Draws the cases of a group small, planned and in full, and prints what differs by more than the rules that applied
/// allow; with plan.exact nothing may by more than 1/255. Returns how many cases fail.
int checkLossless(const Group& group);

} // namespace tarn::imagetest

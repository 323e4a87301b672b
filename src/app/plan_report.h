// A frame's plan for people and for programs.
#pragma once

#include "plan/frame_plan.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tarn {

nlohmann::json toJson(const FramePlan& plan);
/// One line a pass: its name, yes or no, the size of its target, and why.
std::string toTable(const FramePlan& plan);

} // namespace tarn

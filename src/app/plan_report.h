// A frame's plan for people and for programs.
#pragma once

#include "render/frame.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tarn {

nlohmann::json toJson(const FramePlan& plan);
/// One line a pass: its name, yes or no, the size of its target, why, and whose output it reads.
std::string toTable(const FramePlan& plan);

/// The same of a frame that was drawn, with what came of the plan.
nlohmann::json toJson(const FrameReport& report);
std::string toTable(const FrameReport& report);

} // namespace tarn

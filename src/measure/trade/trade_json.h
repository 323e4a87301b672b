// Measurements as JSON, and back. NaN, "nothing to measure", is null.
#pragma once

#include "measure/trade/experiment.h"

#include <nlohmann/json.hpp>

namespace tarn {

nlohmann::json toJson(const ErrorFigures& figures);
ErrorFigures figuresFrom(const nlohmann::json& json);

nlohmann::json toJson(const Cost& cost);
Cost costFrom(const nlohmann::json& json);

nlohmann::json toJson(const ErrorBudget& budget);
ErrorBudget budgetFrom(const nlohmann::json& json);

/// null for NaN and infinity, which JSON cannot say.
nlohmann::json numberJson(double value);
double numberFrom(const nlohmann::json& json);

} // namespace tarn

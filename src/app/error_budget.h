// The error budget of a view: which part of the picture's error each approximation of the frame owns.
//
// Found from both ends: each approximation is put alone into the reference, and taken alone out of the frame.
// Errors do not add up: one may hide another, so that a part taken out can even make the frame worse. Both
// sums are shown beside what all parts do at once.
#pragma once

#include "app/session.h"
#include "measure/trade/budget.h"
#include "measure/trade/sweep.h"
#include "reference/reference.h"

#include <functional>
#include <string>
#include <vector>

namespace tarn {

/// One approximation of a frame.
struct BudgetPart {
    std::string name;
    Changes exact; ///< options that make this part of the frame as exact as it gets
    /// Makes it in the reference, and nothing where the settings do not make it; empty when rays cannot.
    std::function<void(reference::ViewRequest&)> approximate;
};

/// The parts of these settings' frame, seen from this camera.
std::vector<BudgetPart> budgetParts(const Scene& scene, const Settings& settings, const Camera& camera, ivec2 size);

struct BudgetRequest {
    const Scene& scene;
    Settings settings;
    Camera camera;
    double time = 0.0; ///< s
    ivec2 size{320, 240};
    reference::ReferenceOptions reference;     ///< of the pictures that approximations are put into
    const reference::Picture* truth = nullptr; ///< that frames are held against; null: a picture by these options
};

/// Pictures are as shown, without glow, which is an effect of the lens.
ErrorBudget measureBudget(const BudgetRequest& request, Session& session, const reference::Tracer& tracer,
                          Progress* progress);

} // namespace tarn

// Reading the scene in the background while the window shows how far it is.
#pragma once

#include "app/scene_setup.h"
#include "base/progress.h"

#include <future>
#include <optional>

namespace tarn {

class BackgroundLoad {
public:
    /// Starts at once.
    explicit BackgroundLoad(const SceneArguments& arguments);

    /// Waits for the reader: it cannot be stopped half-way.
    ~BackgroundLoad() = default;

    bool done() const;
    /// Waits when it is not done. Throws what the loading threw. Once only.
    SceneSetup take() { return sceneSetup_.get(); }

    SharedProgress::State progress() const { return progress_.state(); }

private:
    SharedProgress progress_;
    std::future<SceneSetup> sceneSetup_; // after what the thread uses, so that it ends first
};

} // namespace tarn

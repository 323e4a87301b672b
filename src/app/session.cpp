#include "app/session.h"

#include "base/error.h"
#include "gl/api.h"

namespace tarn {

Session::Session(const Stage& stage, ivec2 size, Progress* progress)
    : context_(gl::makeHeadlessContext(size)), shaders_(makeShaderLibrary())
{
    requireDrawable(size);
    renderer_ = std::make_unique<Renderer>(stage.scene, stage.settings.options, *shaders_, profiler_, progress);
    renderer_->setOptions(stage.settings.options, stage.settings.water);
}

void requireDrawable(ivec2 size)
{
    const int limit = gl::capabilities().maxTextureSize;
    if (size.x > limit || size.y > limit)
        throw Error("--size {}x{}: this machine draws at most {}x{}", size.x, size.y, limit, limit);
}

void finishGpu() { glFinish(); }

} // namespace tarn

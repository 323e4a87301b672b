#include "app/session.h"

#include "base/error.h"
#include "gl/api.h"

namespace tarn {

Session::Session(const SceneSetup& sceneSetup, ivec2 size, Progress* progress)
    : context_(gl::makeHeadlessContext(size)), shaders_(makeShaderLibrary())
{
    requireDrawable(size);
    renderer_ =
        std::make_unique<Renderer>(sceneSetup.scene, sceneSetup.settings.options, *shaders_, profiler_, progress);
    renderer_->setOptions(sceneSetup.settings.options, sceneSetup.settings.water);
}

void requireDrawable(ivec2 size)
{
    const int limit = gl::capabilities().maxTextureSize;
    if (size.x > limit || size.y > limit)
        throw Error("--size {}x{}: this machine draws at most {}x{}", size.x, size.y, limit, limit);
}

void finishGpu() { glFinish(); }

} // namespace tarn

#include "gl/fence.h"

#include "gl/api.h"

namespace tarn::gl {

namespace {

GLsync handle(void* sync) { return static_cast<GLsync>(sync); }

} // namespace

Fence::~Fence()
{
    if (sync_) glDeleteSync(handle(sync_));
}

void Fence::place()
{
    if (sync_) glDeleteSync(handle(sync_));
    sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
}

bool Fence::passed() const
{
    if (!sync_) return true;
    const GLenum answer = glClientWaitSync(handle(sync_), 0, 0);
    return answer != GL_TIMEOUT_EXPIRED; // a lost context answers with an error for ever: go on, the next call says so
}

void Fence::holdBack() const
{
    if (sync_) glWaitSync(handle(sync_), 0, GL_TIMEOUT_IGNORED);
}

void Fence::wait() const
{
    constexpr GLuint64 second = 1'000'000'000;
    while (sync_ && glClientWaitSync(handle(sync_), 0, second) == GL_TIMEOUT_EXPIRED) {
        // A long frame: ask again.
    }
}

} // namespace tarn::gl

#include "app/interrupt.h"

#include <csignal>

namespace tarn {

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

extern "C" void onSignal(int signal)
{
    interrupted = true;
    std::signal(signal, SIG_DFL);
}

} // namespace

InterruptGuard::InterruptGuard()
{
    interrupted = false;
    interruptBefore_ = std::signal(SIGINT, onSignal);
    terminateBefore_ = std::signal(SIGTERM, onSignal);
}

InterruptGuard::~InterruptGuard()
{
    std::signal(SIGINT, interruptBefore_);
    std::signal(SIGTERM, terminateBefore_);
}

const std::atomic<bool>& InterruptGuard::flag() { return interrupted; }

} // namespace tarn

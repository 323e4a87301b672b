// Ctrl+C as a request: long work polls a flag, saves what it has and ends.
#pragma once

#include <atomic>

namespace tarn {

/// While it lives, SIGINT and SIGTERM set a flag instead of ending the program; a second one ends it. Handlers that
/// stood before stand again afterwards. One at a time.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    static const std::atomic<bool>& flag();

private:
    using Handler = void (*)(int);
    Handler interruptBefore_, terminateBefore_;
};

} // namespace tarn

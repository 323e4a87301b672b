// Ctrl+C as a request: long work looks at a flag, saves what it has and ends.
#pragma once

#include <atomic>

namespace tarn {

/// While it lives, SIGINT and SIGTERM set a flag instead of ending the program; a second one ends it.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    static const std::atomic<bool>& flag();
};

} // namespace tarn

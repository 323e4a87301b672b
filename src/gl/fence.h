// A point in one context's work that another may wait for.
//
//     fence.place();                    // here, after the commands; in the context that gave them
//     if (fence.passed()) …             // in any context of the share group: asks, does not wait
//     fence.holdBack();                 // what this context is given from now on runs after it; the caller does not
//     wait
#pragma once

namespace tarn::gl {

class Fence {
public:
    Fence() = default;
    ~Fence();
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;

    /// Sends the commands before it on their way, too: other contexts see a fence only once it was sent.
    void place();
    /// True when it was never placed.
    bool passed() const;
    void holdBack() const;
    /// The caller waits. Only in the context that placed it.
    void wait() const;

private:
    void* sync_ = nullptr; ///< GLsync
};

} // namespace tarn::gl

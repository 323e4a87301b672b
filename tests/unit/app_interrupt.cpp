// Ctrl+C as a request, and only while somebody listens to it.
#include "app/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>

namespace tarn {
namespace {

volatile std::sig_atomic_t outerCalls = 0;

extern "C" void countCall(int /*signal*/) { outerCalls = outerCalls + 1; }

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, IsARequestWhileTheGuardLives)
{
    const auto before = std::signal(GetParam(), countCall);
    outerCalls = 0;
    {
        const InterruptGuard guard;
        EXPECT_FALSE(InterruptGuard::flag());
        std::raise(GetParam());
        EXPECT_TRUE(InterruptGuard::flag());
        const auto second = std::signal(GetParam(), SIG_IGN);
        EXPECT_EQ(second, SIG_DFL) << "a second one must end the program";
    }
    EXPECT_EQ(outerCalls, 0);
    std::raise(GetParam());
    EXPECT_EQ(outerCalls, 1) << "the handler from before stands again";
    {
        const InterruptGuard guard;
        EXPECT_FALSE(InterruptGuard::flag()) << "an old request is forgotten";
    }
    std::signal(GetParam(), before);
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM));

} // namespace
} // namespace tarn

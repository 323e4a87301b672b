#include "base/memory.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

namespace tarn::test {

TEST(ProcessMemory, CountsWhatIsInUse)
{
    const ProcessMemory before = processMemory();
    EXPECT_GT(before.resident, before.files);
    EXPECT_GE(before.peak, before.resident);
    const std::vector<char> block(std::size_t{64} << 20, 1);
    EXPECT_GT(processMemory().resident, before.resident + (std::size_t{60} << 20));
    EXPECT_EQ(block.back(), 1);
}

// What is freed between blocks in use stays with the process until it is given back.
TEST(ProcessMemory, IsGivenBackBetweenBlocksInUse)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's allocator keeps its own pages";
#endif
    constexpr std::size_t blockSize = 1024, count = 64 * 1024;
    std::vector<std::unique_ptr<char[]>> blocks(count);
    for (auto& block : blocks) {
        block = std::make_unique<char[]>(blockSize);
        std::memset(block.get(), 1, blockSize);
    }
    for (std::size_t i = 0; i < count; ++i)
        if (i % 64 != 0) blocks[i].reset();
    const std::size_t freed = processMemory().resident;
    returnFreeMemory();
    EXPECT_LT(processMemory().resident, freed - (std::size_t{32} << 20));
    EXPECT_EQ(blocks[0][0], 1);
}

} // namespace tarn::test

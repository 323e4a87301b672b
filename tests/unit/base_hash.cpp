// Hashes of contents.
#include "base/hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tarn::test {
namespace {

/// The test vectors of its authors: stored results are found by it in later versions too.
TEST(Fnv1a, IsThePublishedFunction)
{
    EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325u);
    EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cu);
    EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8u);
}

TEST(HashOf, TellsContentsApart)
{
    std::set<std::uint64_t> hashes;
    std::string text(40, '\0');
    hashes.insert(hashOf(text));
    for (std::size_t i = 0; i < text.size(); ++i) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string other = text;
            other[i] = static_cast<char>(1 << bit);
            hashes.insert(hashOf(other));
        }
        hashes.insert(hashOf(text.substr(0, i)));
    }
    EXPECT_EQ(hashes.size(), 1u + 40u * 8u + 40u);
}

// What is empty may have no address.
TEST(HashOf, NothingHasAHash) { EXPECT_EQ(hashOf({}), hashOf("")); }

} // namespace
} // namespace tarn::test

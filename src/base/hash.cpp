#include "base/hash.h"

#include <cstddef>
#include <cstring>

namespace tarn {

namespace {

constexpr std::uint64_t offsetBasis = 0xcbf29ce484222325u, prime = 0x100000001b3u;

} // namespace

std::uint64_t fnv1a(std::string_view text)
{
    std::uint64_t hash = offsetBasis;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * prime;
    return hash;
}

std::uint64_t hashOf(std::string_view bytes)
{
    std::uint64_t hash = offsetBasis ^ bytes.size();
    const auto mix = [&hash](std::uint64_t word) {
        hash = (hash ^ word) * prime;
        hash ^= hash >> 32; // else the upper bits of a word never reach the lower ones of the hash
    };
    std::uint64_t word = 0;
    std::size_t i = 0;
    for (; i + sizeof word <= bytes.size(); i += sizeof word) {
        std::memcpy(&word, bytes.data() + i, sizeof word);
        mix(word);
    }
    word = 0;
    bytes.copy(reinterpret_cast<char*>(&word), sizeof word, i); // no bytes may have no address
    mix(word);
    return hash;
}

} // namespace tarn

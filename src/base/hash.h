// Numbers that tell contents apart, not ones that keep secrets.
#pragma once

#include <cstdint>
#include <string_view>

namespace tarn {

/// FNV-1a of 64 bits (Fowler, Noll and Vo 1991). The same in every run, on every machine and in every version, which
/// std::hash is not: the names of stored results are made of it.
std::uint64_t fnv1a(std::string_view text);

/// The same steps over eight bytes at a time, for megabytes. It may change from version to version and from machine to
/// machine: for the keys of caches.
std::uint64_t hashOf(std::string_view bytes);

} // namespace tarn

// The memory of the process.
#pragma once

#include <cstddef>

namespace tarn {

/// Bytes of main memory; 0 where the system does not tell.
struct ProcessMemory {
    std::size_t resident = 0; ///< now
    std::size_t files = 0;    ///< of that, pages of mapped files: programs and libraries, which the system can drop
    std::size_t peak = 0;     ///< resident at most so far
};
ProcessMemory processMemory();

/// Gives the system back what was freed: the C library keeps pages between blocks that are in use. For when much was
/// freed that is not needed again soon, as after loading or after compiling. Takes some milliseconds; from any thread.
void returnFreeMemory();

} // namespace tarn

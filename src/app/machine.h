// The machine that something was measured on.
#pragma once

#include <cstddef>
#include <string>

namespace tarn {

/// The processor, which is the renderer as well where OpenGL is drawn in software: "…, 8 threads".
std::string machineText();

/// What this process takes of main memory, bytes; 0 where the system does not tell.
struct ProcessMemory {
    std::size_t resident = 0; ///< now
    std::size_t peak = 0;     ///< at most so far
};
ProcessMemory processMemory();

} // namespace tarn

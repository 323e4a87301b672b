#include "base/memory.h"

#include <fstream>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace tarn {

ProcessMemory processMemory()
{
    ProcessMemory memory;
    std::ifstream file("/proc/self/status"); // proc(5)
    std::string name, unit;
    for (std::size_t kibibytes = 0; file >> name;) {
        if (name == "VmRSS:" && file >> kibibytes) memory.resident = 1024 * kibibytes;
        if (name == "RssFile:" && file >> kibibytes) memory.files = 1024 * kibibytes;
        if (name == "VmHWM:" && file >> kibibytes) memory.peak = 1024 * kibibytes;
        std::getline(file, unit);
    }
    return memory;
}

void returnFreeMemory()
{
#if defined(__GLIBC__)
    malloc_trim(0);
#endif
}

} // namespace tarn

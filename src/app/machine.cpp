#include "app/machine.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace tarn {

std::string machineText()
{
    const unsigned int threads = std::thread::hardware_concurrency();
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
            return fmt::format("{}, {} threads", line.substr(colon + 2), threads);
    return fmt::format("{} threads", threads);
}

ProcessMemory processMemory()
{
    ProcessMemory memory;
    std::ifstream file("/proc/self/status"); // proc(5)
    std::string name, unit;
    for (std::size_t kibibytes = 0; file >> name;) {
        if (name == "VmRSS:" && file >> kibibytes) memory.resident = 1024 * kibibytes;
        if (name == "VmHWM:" && file >> kibibytes) memory.peak = 1024 * kibibytes;
        std::getline(file, unit);
    }
    return memory;
}

} // namespace tarn

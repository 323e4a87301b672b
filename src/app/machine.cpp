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

} // namespace tarn

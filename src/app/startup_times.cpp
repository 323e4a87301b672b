#include "app/startup_times.h"

#include <unistd.h>

#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

namespace tarn {

namespace {

double seconds(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// On CLOCK_BOOTTIME, to a hundredth of a second (proc(5), starttime); now where the system does not tell.
double processStart()
{
    std::ifstream file("/proc/self/stat");
    std::string line;
    std::getline(file, line);
    // The second field is the program's name in brackets, which may hold anything.
    std::istringstream fields(line.substr(line.rfind(')') + 1));
    std::string field;
    for (int i = 3; i < 22; ++i) fields >> field;
    double ticks = 0.0;
    if (!(fields >> ticks)) return seconds(CLOCK_BOOTTIME);
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

} // namespace

StartupTime sinceProcessStart()
{
    static const double start = processStart();
    return {seconds(CLOCK_BOOTTIME) - start, seconds(CLOCK_PROCESS_CPUTIME_ID)};
}

void StartupTimes::note(StartupEvent event)
{
    const std::lock_guard lock(mutex_);
    auto& time = times_[static_cast<std::size_t>(event)];
    if (!time) time = sinceProcessStart();
}

std::optional<StartupTime> StartupTimes::at(StartupEvent event) const
{
    const std::lock_guard lock(mutex_);
    return times_[static_cast<std::size_t>(event)];
}

} // namespace tarn

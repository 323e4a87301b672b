#include "base/thread_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace tarn {

void lowerThreadPriority()
{
#ifdef __linux__
    // Linux keeps nice values by thread, and PRIO_PROCESS takes the number of one.
    constexpr int least = 19;
    setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), least);
#endif
}

} // namespace tarn

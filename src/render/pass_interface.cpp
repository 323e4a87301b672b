#include "render/pass_interface.h"

namespace tarn {

std::vector<PassId> readBy(PassId pass, const FramePlan& plan)
{
    std::vector<PassId> found;
    if (!plan[pass].wanted) return found;
    const Resources reads = interfaceOf(pass, plan).reads;
    for (std::size_t i = 0; i < static_cast<std::size_t>(pass); ++i) {
        const PassId other = static_cast<PassId>(i);
        if (plan[other].wanted && interfaceOf(other, plan).writes.meets(reads)) found.push_back(other);
    }
    return found;
}

} // namespace tarn

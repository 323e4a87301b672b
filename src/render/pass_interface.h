// What the passes of a frame write for each other: each declares beside its code what it reads and what it writes,
// given a plan. `tarn explain` tells of it, and a test holds it against the textures that the passes bind.
#pragma once

#include "plan/frame_plan.h"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace tarn {

/// A set of resources.
class Resources {
public:
    constexpr Resources() = default;
    constexpr Resources(std::initializer_list<Resource> resources)
    {
        for (const Resource resource : resources) bits_ |= bit(resource);
    }
    constexpr bool has(Resource resource) const { return (bits_ & bit(resource)) != 0; }
    constexpr bool meets(Resources other) const { return (bits_ & other.bits_) != 0; }
    constexpr Resources operator|(Resources other) const
    {
        other.bits_ |= bits_;
        return other;
    }

private:
    static constexpr std::uint32_t bit(Resource resource)
    {
        return std::uint32_t{1} << static_cast<unsigned>(resource);
    }
    std::uint32_t bits_ = 0;
};

struct PassInterface {
    Resources reads, writes;
};

/// Of a pass that the plan wants. Defined in renderer.cpp, which alone knows every pass.
PassInterface interfaceOf(PassId pass, const FramePlan& plan);

/// The passes before a wanted one whose output it reads in the plan's frame, in their order.
std::vector<PassId> readBy(PassId pass, const FramePlan& plan);

} // namespace tarn

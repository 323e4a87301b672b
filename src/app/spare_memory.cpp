#include "app/spare_memory.h"

#include "app/live_picture.h"
#include "base/memory.h"

namespace tarn {

namespace {

constexpr std::chrono::seconds lookInterval{1};
constexpr std::size_t growth = 64 << 20; ///< bytes, before it is worth looking for free pages again

} // namespace

void SpareMemory::release(const LivePicture& picture)
{
    if (hasTexels_ && picture.times().at(StartupEvent::uploaded)) {
        hasTexels_ = false;
        releaseTexels(scene_);
        trim();
    }
    // Compiling leaves the most behind.
    if (!isBuilt_ && picture.isBuilt()) {
        isBuilt_ = true;
        trim();
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - lastLook_ < lookInterval) return;
    lastLook_ = now;
    if (processMemory().resident > lastResident_ + growth) trim();
}

void SpareMemory::trim()
{
    returnFreeMemory();
    lastResident_ = processMemory().resident;
}

} // namespace tarn

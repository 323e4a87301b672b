// Work that nobody waits for.
#pragma once

namespace tarn {

/// The calling thread runs when no other of its process or user wants the processor. Without effect where the system
/// cannot.
void lowerThreadPriority();

} // namespace tarn

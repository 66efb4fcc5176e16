// Inputs of frames as bytes and back: what a recording keeps of each frame.
//
// Only tools whose input differs from the frame before are written. The same bits come back.
#pragma once

#include <span>

#include "base/state/run_length.h"
#include "simulation/simulation.h"

namespace resect {

// before: the input of the frame before; an input without tools for the first frame of a sequence.
Bytes frameToBytes(const FrameInput& input, const FrameInput& before);

// Throws Error if the bytes are cut off or damaged: a wrong length, number or kind of edit.
FrameInput frameFromBytes(std::span<const std::byte> bytes, const FrameInput& before);

}  // namespace resect

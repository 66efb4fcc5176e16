// Converts the input of a frame to bytes and back. A recording keeps these bytes for each frame.
//
// The input of a tool is left out if it equals the tool's input in the previous frame. The input
// that is read back equals the input that was written, bit for bit.
#pragma once

#include <span>

#include "base/state/run_length.h"
#include "simulation/simulation.h"

namespace resect {

// before: the input of the previous frame. If it is an input without tools, the whole input is
// written.
Bytes frameToBytes(const FrameInput& input, const FrameInput& before);

// before: as for frameToBytes(). Throws Error if the bytes are truncated or damaged: if the number
// of bytes, a value or the kind of a tissue edit is wrong.
FrameInput frameFromBytes(std::span<const std::byte> bytes, const FrameInput& before);

}  // namespace resect

// Tells a complete .mp4 file from a truncated one.
#pragma once

namespace resect {

// Whether the boxes of the file (ISO/IEC 14496-12, 4.2) end exactly at its last byte, and include
// the index (moov) and the pictures (mdat). Reads only the headers of the boxes. Does not change
// the file position of the descriptor.
bool isWholeMp4(int descriptor);

}  // namespace resect

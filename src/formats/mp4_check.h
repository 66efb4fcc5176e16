// Tells a whole .mp4 file from one that was cut off.
#pragma once

namespace resect {

// Whether the boxes of the file (ISO/IEC 14496-12, 4.2) fill it to its last byte, with the index
// (moov) and the pictures (mdat) among them. Reads their headers alone; the descriptor's position
// stays.
bool isWholeMp4(int descriptor);

}  // namespace resect

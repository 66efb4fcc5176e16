// Tells a complete .mp4 file from a truncated one.
#pragma once

namespace resect {

// Whether a .mp4 file is complete. A .mp4 file consists of boxes (ISO/IEC 14496-12, section 4.2).
// The file counts as complete if the last box ends exactly at the last byte of the file, and if
// there are boxes with the index (moov) and with the pictures (mdat). Only the headers of the boxes
// are read. The file position of the descriptor does not change.
bool isWholeMp4(int descriptor);

}  // namespace resect

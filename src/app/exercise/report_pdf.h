// The debrief of an attempt as PDF, for printing and for archives.
#pragma once

#include <string>

namespace resect {

// Returns the bytes of an A4 PDF file. page: HTML from debriefPage() (skills/report/debrief.h).
// Charts become bitmaps. Video clips are left out. A rotating view is shown by its first picture
// only. Creates Qt's application object. A program may have only one such object, so the window
// must not call this function.
std::string reportPdf(const std::string& page, const std::string& title);

}  // namespace resect

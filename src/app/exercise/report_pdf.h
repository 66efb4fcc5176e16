// The debrief of an attempt as PDF, for printing and for archives.
#pragma once

#include <string>

namespace resect {

// Returns the bytes of an A4 PDF file. page: HTML from debriefPage() (skills/report/debrief.h).
// Charts become bitmaps, video clips are left out, and of a rotating view only the first picture is
// shown. Creates Qt's application object. A program may have only one, so the window must not call
// this function.
std::string reportPdf(const std::string& page, const std::string& title);

}  // namespace resect

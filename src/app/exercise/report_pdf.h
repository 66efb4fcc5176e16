// The debrief of an attempt as PDF, for printing and for files of records.
#pragma once

#include <string>

namespace resect {

// The bytes of a PDF file, A4, of a page that debriefPage() (skills/report/debrief.h) has made.
// Charts become pictures, clips are left out, and of a picture that turns the first one is shown.
// Makes an application object of Qt, of which a program has one: not to be called in the window.
std::string reportPdf(const std::string& page, const std::string& title);

}  // namespace resect

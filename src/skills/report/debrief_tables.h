// The tables of a debrief.
#pragma once

#include <string>

#include "skills/report/debrief.h"

namespace resect {

// All measures beside what was wanted, the attempt before, and the reference.
std::string figureTable(const Debrief& debrief);
// What was published, with its source; empty if nothing was. own: measures of an attempt to be set
// beside it; empty: none.
std::string studyTable(std::span<const PublishedStudy> studies, std::span<const Measured> own);
// A section about the vessels that were cut; empty if none was.
std::string vesselSection(const Attempt& attempt);
std::string ledgerTable(const Attempt& attempt);
// A section about all attempts; empty if there is one only.
std::string historySection(const Debrief& debrief);

}  // namespace resect

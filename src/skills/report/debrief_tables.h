// The tables of a debrief.
#pragma once

#include <string>

#include "skills/report/debrief.h"

namespace resect {

// All measures of the attempt, beside the task's limits, the previous attempt and the reference.
std::string figureTable(const Debrief& debrief);
// The published figures with their sources; "" if there are none. own: measures of an attempt that
// are shown beside them; may be empty.
std::string studyTable(std::span<const PublishedStudy> studies, std::span<const Measured> own);
// A section about the vessels that were cut; "" if none was cut.
std::string vesselSection(const Attempt& attempt);
// A table of the amounts of tissue and blood at the end, and of the pieces.
std::string ledgerTable(const Attempt& attempt);
// A section about all attempts of the learner; "" if there is only one.
std::string historySection(const Debrief& debrief);

}  // namespace resect

// The tables of a debrief, the report about an attempt.
#pragma once

#include <string>

#include "skills/report/debrief.h"

namespace resect {

// A table of all measures of the last attempt. Further columns give the task's limits, the previous
// attempt and the mean of the reference attempts.
std::string figureTable(const Debrief& debrief);
// A table of the figures of published studies, with their sources; "" if there are none. own:
// measures of an attempt, which are shown beside the published figures; may be empty.
std::string studyTable(std::span<const PublishedStudy> studies, std::span<const Measured> own);
// A section about the vessels that were cut; "" if none was cut.
std::string vesselSection(const Attempt& attempt);
// A table of the organ's pieces, and of the amounts of tissue and blood at the end.
std::string ledgerTable(const Attempt& attempt);
// A section about all attempts of the learner; "" if there is only one.
std::string historySection(const Debrief& debrief);

}  // namespace resect

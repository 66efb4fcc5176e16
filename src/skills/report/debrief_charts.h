// The charts of a debrief: force, blood and tissue over time, and the paths of the tips.
#pragma once

#include <string>

#include "skills/score/verdict.h"

namespace resect {

std::string timelines(const Scored& scored);
std::string pathViews(const Scored& scored);
// A section about the margin, the least distance from the goal's structure to a cut or bared face;
// "" if no margin was measured.
std::string marginSection(const Attempt& attempt);

}  // namespace resect

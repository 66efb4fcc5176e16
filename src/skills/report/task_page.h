// What an exercise teaches, as one HTML page that needs nothing else, for learners before they
// begin and for teachers who choose.
#pragma once

#include <string>

#include "operation/scenario.h"

namespace resect {

// scenario: with a task. A picture beside its file (.png instead of .toml) is shown. Throws Error
// if a template or a published study is missing.
std::string taskPage(const Scenario& scenario);

}  // namespace resect

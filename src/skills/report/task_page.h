// A self-contained HTML page that says what an exercise teaches, for learners before they begin and
// for teachers who choose exercises.
#pragma once

#include <string>

#include "operation/scenario.h"

namespace resect {

// scenario: with a task. If there is a picture beside the scenario's file (.png instead of .toml),
// the page shows it. Throws Error if a template or a published study is missing.
std::string taskPage(const Scenario& scenario);

}  // namespace resect

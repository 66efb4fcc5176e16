// A self-contained HTML page that says what an exercise teaches, for learners before they begin and
// for teachers who choose exercises.
#pragma once

#include <string>

#include "operation/scenario.h"

namespace resect {

// scenario: must have a task. If the folder of the scenario's file has a picture with the same name
// (.png instead of .toml), the page shows this picture. Throws Error if a template or a published
// study is missing.
std::string taskPage(const Scenario& scenario);

}  // namespace resect

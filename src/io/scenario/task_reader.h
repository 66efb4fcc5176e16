// Reads the table [task] of a scenario. docs/scenarios.md, "[task]", lists the keys.
#pragma once

#include <string>

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

// Throws Error, with file, line and key, if a value is wrong, a key is unknown, or the task names
// an organ, a structure, a landmark or an instrument that the scenario lacks. Structures and
// landmarks of a file of particles are not known here. So for organs from a file they are checked
// after the organ is loaded (skills/attempt/goal_places.h).
Task readTask(const TomlTable& t, const Scenario& scenario);

// The same from the text that a recording keeps (Task::text). `name` stands for the file in Errors.
Task parseTask(const std::string& text, const std::string& name, const Scenario& scenario);

}  // namespace resect

// Reads the table [task] of a scenario. docs/scenarios.md, "[task]", lists the keys.
#pragma once

#include <string>

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

// Throws Error, with file, line and key, if a value is wrong, a key is unknown, or the task names
// an organ, a structure, a landmark or an instrument that the scenario lacks. If an organ comes
// from a file, its structures and landmarks may not be known yet. In this case they are checked
// after the organ has been loaded (skills/attempt/goal_places.h).
Task readTask(const TomlTable& t, const Scenario& scenario);

// Reads a task from the text that a recording keeps (Task::text). Errors use `name` as the file's
// name.
Task parseTask(const std::string& text, const std::string& name, const Scenario& scenario);

}  // namespace resect

// Writes tasks: the text of the scenario file for an exercise that a user has made in the window.
#pragma once

#include <string>

#include "operation/scenario.h"

namespace resect {

// Returns the task with another level of difficulty. The level is changed in Task::text, too, so
// that a recording keeps the new level.
Task atLevel(const Task& task, TaskLevel level);

// The text of a scenario file with the scenario's task. It is the text of the file from which the
// scenario was read (Scenario::file), except that these parts are taken from `scenario`: title,
// description, sources, cells and labels of the organs, instruments and their motions, and the
// task. Names of files are absolute. Throws Error if Scenario::file cannot be read.
std::string exerciseText(const Scenario& scenario);

}  // namespace resect

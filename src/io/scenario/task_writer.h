// Writes tasks: an exercise that somebody makes in the window becomes a scenario file.
#pragma once

#include <string>

#include "operation/scenario.h"

namespace resect {

// The task at another level, its text too, so that a recording keeps the level.
Task atLevel(const Task& task, TaskLevel level);

// The text of a scenario file with the scenario's task: the file from which the scenario was read
// (Scenario::file), with the scenario's title and description, the sources, cells and labels of its
// organs, its instruments with their keys, and its task. Names of files that it needs are absolute.
// Throws Error if that file cannot be read.
std::string exerciseText(const Scenario& scenario);

}  // namespace resect

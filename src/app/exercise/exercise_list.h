// The exercises that the window offers. Exercises that the user has added or made come first, the
// newest at the top. Exercises that come with Resect follow.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "operation/scenario.h"

namespace resect {

struct Exercise {
  std::filesystem::path file, picture;  // the picture may be missing
  std::string name;                     // name of the scenario
  std::string title;
  Task task;
};

// The list of all exercises. For each file that can no longer be read, a sentence is added to
// `complaints`.
std::vector<Exercise> allExercises(std::vector<std::string>& complaints);

// Adds a file of the user to the list. Throws Error if the file is not a scenario with a task.
void addExercise(const std::filesystem::path& file);

// Returns the scenario with only those instruments that its task allows.
Scenario asExercise(Scenario scenario);

}  // namespace resect

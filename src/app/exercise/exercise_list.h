// The exercises that the window offers: those that the user has added or made, the last one first,
// and those that come with Resect.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "operation/scenario.h"

namespace resect {

struct Exercise {
  std::filesystem::path file, picture;  // the picture need not be there
  std::string name;                     // of the scenario
  std::string title;
  Task task;
};

// complaints: sentences about files of the user that cannot be read any more.
std::vector<Exercise> allExercises(std::vector<std::string>& complaints);

// Adds a file of the user to the list. Throws Error if it is no scenario with a task.
void addExercise(const std::filesystem::path& file);

// The scenario as an exercise: with those instruments only that its task allows.
Scenario asExercise(Scenario scenario);

}  // namespace resect

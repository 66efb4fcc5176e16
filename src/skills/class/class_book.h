// A class: the attempts of several learners at several tasks, and what follows from them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "skills/metrics/learning_curve.h"
#include "skills/score/verdict.h"

namespace resect {

// An attempt as a class keeps it: its verdict and its measures, without its tracks.
struct ClassAttempt {
  std::string file;
  bool passed = false, graded = true, goalReached = false;
  double score = 0;
  std::string reason;
  std::vector<Measured> measures;  // of the whole
  std::vector<Check> checks;
  int undos = 0;
  TaskLevel level = TaskLevel::Medium;
};
ClassAttempt classAttempt(const Scored& scored);

struct LearnerCourse {
  std::string learner;
  std::vector<ClassAttempt> attempts;  // the oldest first
};

struct TaskCourse {
  std::string scenario, title;
  std::vector<LearnerCourse> learners;
};

struct ClassBook {
  std::string name;
  std::vector<TaskCourse> tasks;
  std::vector<std::string> refused;  // sentences: recordings that could not be scored
};

// A recording in the folder of a class, and whose it is: the name of its sub-folder, or of the file
// up to its last number ("anna-2.resect").
struct ClassFile {
  std::filesystem::path path;
  std::string learner;  // for output
  std::string name;     // of the learner
};
// All recordings in the folder and its sub-folders, by learner and then in the order of their
// names, in which numbers count as numbers (2 before 10). Throws Error if there is no such folder,
// or no recording in it.
std::vector<ClassFile> classFiles(const std::filesystem::path& folder);

// Replaces the learners' names by "learner 1" and so on, in the order of the names.
void usePseudonyms(std::vector<ClassFile>& files);

// How hard a check is: of the graded attempts at a task the share that kept it. Little time, way or
// blood of an attempt that missed its goal does not count as kept.
struct CheckDifficulty {
  std::string measure;  // "": the goal
  int kept = 0, attempts = 0;
};
std::vector<CheckDifficulty> difficulties(const TaskCourse& task);

// Passed or not, of the attempts that are graded.
std::vector<bool> passes(const LearnerCourse& course);

}  // namespace resect

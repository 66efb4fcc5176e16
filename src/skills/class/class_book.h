// A class: the attempts of several learners at several tasks, and figures computed from them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "skills/metrics/learning_curve.h"
#include "skills/score/verdict.h"

namespace resect {

// The part of an attempt that a class keeps: verdict and measures, but no tracks.
struct ClassAttempt {
  std::string file;
  bool passed = false, graded = true, goalReached = false;
  double score = 0;
  std::string reason;
  std::vector<Measured> measures;  // measures of the whole attempt
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
  std::vector<std::string> refused;  // one error message per recording that could not be scored
};

// A recording in the folder of a class, and its learner. For a file in a sub-folder, the learner's
// name is the name of the sub-folder. For a file in the folder itself, the learner's name is the
// file's name without the number at its end ("anna" for "anna-2.resect").
struct ClassFile {
  std::filesystem::path path;
  std::string learner;  // for output: `name`, or a pseudonym
  std::string name;     // the learner's name
};
// All recordings in the folder and its sub-folders, sorted by learner and then by path in natural
// order (2 before 10). Throws Error if there is no such folder, or no recording in it.
std::vector<ClassFile> classFiles(const std::filesystem::path& folder);

// Replaces the learners' names by "learner 1" and so on, in the order of the names.
void usePseudonyms(std::vector<ClassFile>& files);

// How hard a check is. A check compares a measure with a limit or band (score/verdict.h). attempts:
// number of graded attempts at the task in which the check was made. kept: number of these attempts
// in which the limit or band was kept. Some measures add up during the work, such as time (addsUp()
// in findings.h). If an attempt missed its goal, its kept checks of such measures are left out of
// both numbers: they may have been kept only because little was done.
struct CheckDifficulty {
  std::string measure;  // "": the goal
  int kept = 0, attempts = 0;
};
std::vector<CheckDifficulty> difficulties(const TaskCourse& task);

// For each graded attempt, in order, whether it passed.
std::vector<bool> passes(const LearnerCourse& course);

}  // namespace resect

// The folder of attempts. It has a sub-folder for each learner, with recordings and reports, and a
// file with the history of all scores. `resect class` reads such a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "skills/class/history.h"

namespace resect {

// The default folder for attempts. Its name is "attempts". It is in the same folder as
// recordingsFolder(), where the window keeps recordings.
std::filesystem::path usualAttemptsFolder();

// Converts a text to the name of a folder, without characters that a file system might refuse. If
// this name would be empty or longer than 60 bytes, the result is "learner".
std::string learnerName(const std::string& text);

// Names of the learners' sub-folders, in alphabetical order.
std::vector<std::string> learnersIn(const std::filesystem::path& folder);

// Path of the learner's next recording of the exercise. The file's name is, for example,
// "touch-and-hold-3.resect". Creates the learner's folder; throws Error if that fails.
std::filesystem::path newAttempt(const std::filesystem::path& folder, const std::string& learner,
                                 const std::string& exercise);

// Path of the file with the history of scores.
std::filesystem::path historyIn(const std::filesystem::path& folder);

// The learner's scored attempts at all exercises. The result is empty if there is no history yet.
std::vector<HistoryEntry> attemptsOf(const std::filesystem::path& folder,
                                     const std::string& learner);

}  // namespace resect

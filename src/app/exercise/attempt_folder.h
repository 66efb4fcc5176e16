// The folder of attempts: a sub-folder of recordings and reports for each learner, and the history
// of their scores. `resect class` reads such a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "skills/class/history.h"

namespace resect {

// Where attempts are kept unless another folder was chosen: the folder "attempts" beside the
// window's folder of recordings.
std::filesystem::path usualAttemptsFolder();

// The text as the name of a folder, without characters that a file system might refuse. If the name
// would be empty or longer than 60 bytes, it is "learner".
std::string learnerName(const std::string& text);

// Names of the learners' sub-folders, in alphabetical order.
std::vector<std::string> learnersIn(const std::filesystem::path& folder);

// Path of the learner's next recording of the exercise; its last part is, for example,
// "touch-and-hold-3.resect". Creates the learner's folder; throws Error if that fails.
std::filesystem::path newAttempt(const std::filesystem::path& folder, const std::string& learner,
                                 const std::string& exercise);

// Path of the file with the history of scores.
std::filesystem::path historyIn(const std::filesystem::path& folder);

// The learner's scored attempts at all exercises; none if there is no history yet.
std::vector<HistoryEntry> attemptsOf(const std::filesystem::path& folder,
                                     const std::string& learner);

}  // namespace resect

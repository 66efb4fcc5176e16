// The history of learners: their scored attempts, in a SQLite file on this machine.
//
// A class keeps its scores there too, so that a recording is played and scored only once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "record/file/database.h"
#include "skills/class/class_book.h"

namespace resect {

// To be increased when a measure, a goal or the verdict is defined in another way: older scores are
// then made again.
inline constexpr int kScoringVersion = 3;

struct HistoryEntry {
  std::string key;      // scoreKey()
  std::string learner;  // as it was given
  std::string scenario, title;
  std::int64_t written = 0;     // when the recording was last written, s since 1970
  bool familiarisation = true;  // the task's: a first attempt is not graded
  ClassAttempt attempt;
};

// What a score depends on: the bytes of the recording, the task if it is another one than the
// recording's own, the level, and kScoringVersion.
std::string scoreKey(const std::filesystem::path& recording, const std::optional<Task>& task,
                     const std::optional<TaskLevel>& level);
std::int64_t writtenAt(const std::filesystem::path& recording);
HistoryEntry historyEntry(const Scored& scored, std::string key);

class LearnerHistory {
 public:
  // Opens or creates the file. Throws Error if it is something else than a history, or cannot be
  // written.
  explicit LearnerHistory(const std::filesystem::path& path);

  // Replaces the entry with the same key and learner.
  void keep(const HistoryEntry& entry);
  std::optional<HistoryEntry> find(const std::string& key, const std::string& learner);
  // By learner, scenario and time; of one learner, or of all if `learner` is empty.
  std::vector<HistoryEntry> entries(const std::string& learner = "");
  // Deletes all entries of a learner, so that nothing of them is left in the file, and returns
  // their number.
  std::int64_t remove(const std::string& learner);

 private:
  Database database_;
};

}  // namespace resect

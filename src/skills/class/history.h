// The history of learners: their scored attempts, in a SQLite file on this machine.
//
// Such a file also keeps the scores of a class, so that each recording is played and scored only
// once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "record/file/database.h"
#include "skills/class/class_book.h"

namespace resect {

// To be increased when the definition of a measure, a goal or the verdict changes. Older scores are
// then computed again.
inline constexpr int kScoringVersion = 3;

struct HistoryEntry {
  std::string key;      // scoreKey()
  std::string learner;  // the learner's name as it was given
  std::string scenario, title;
  std::int64_t written = 0;     // when the recording was last written, s since 1970
  bool familiarisation = true;  // Task::familiarisation: the first attempt is not graded
  ClassAttempt attempt;
};

// A digest of everything on which a score depends: the bytes of the recording, the level,
// kScoringVersion and, if it is given, `task`, which replaces the task of the recording.
std::string scoreKey(const std::filesystem::path& recording, const std::optional<Task>& task,
                     const std::optional<TaskLevel>& level);
// When the file was last written, s since 1970.
std::int64_t writtenAt(const std::filesystem::path& recording);
HistoryEntry historyEntry(const Scored& scored, std::string key);

class LearnerHistory {
 public:
  // Opens or creates the file. Throws Error if it is not a history or cannot be written.
  explicit LearnerHistory(const std::filesystem::path& path);

  // Adds the entry. It replaces an entry with the same key and the same learner.
  void keep(const HistoryEntry& entry);
  std::optional<HistoryEntry> find(const std::string& key, const std::string& learner);
  // The entries of one learner; if `learner` is empty, the entries of all learners. Sorted by
  // learner, scenario and HistoryEntry::written.
  std::vector<HistoryEntry> entries(const std::string& learner = "");
  // Whether this history has an attempt of the learner at the scenario.
  bool hasTried(const std::string& learner, const std::string& scenario);
  // Deletes all entries of a learner, without traces in the file. Returns the number of these
  // entries.
  std::int64_t remove(const std::string& learner);

 private:
  Database database_;
};

}  // namespace resect

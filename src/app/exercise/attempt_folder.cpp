#include "app/exercise/attempt_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "base/error.h"
#include "record/session_recordings.h"

namespace resect {

namespace fs = std::filesystem;

fs::path usualAttemptsFolder() { return recordingsFolder().parent_path() / "attempts"; }

std::string learnerName(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  std::string name;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool plain = code >= 0x80 || std::isalnum(code) || c == '-' || c == '_' || c == ' ';
    name += plain ? c : '_';
  }
  while (!name.empty() && name.back() == ' ') name.pop_back();
  name.erase(0, std::min(name.find_first_not_of(' '), name.size()));
  return name.empty() || name.size() > kLongest ? "learner" : name;
}

std::vector<std::string> learnersIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ec;
  for (fs::directory_iterator at(folder, ec), end; !ec && at != end; at.increment(ec))
    if (at->is_directory(ec)) names.push_back(at->path().filename().string());
  std::ranges::sort(names);
  return names;
}

fs::path newAttempt(const fs::path& folder, const std::string& learner,
                    const std::string& exercise) {
  const fs::path own = folder / learner;
  std::error_code ec;
  fs::create_directories(own, ec);
  if (ec)
    throw error("{}: cannot be made: {}; choose another folder for the attempts", own.string(),
                ec.message());
  int last = 0;
  for (fs::directory_iterator at(own, ec), end; !ec && at != end; at.increment(ec)) {
    const std::string name = at->path().stem().string();
    if (at->path().extension() != ".resect" || !name.starts_with(exercise + "-")) continue;
    int number = 0;
    const char* digits = name.data() + exercise.size() + 1;
    if (std::from_chars(digits, name.data() + name.size(), number).ec == std::errc())
      last = std::max(last, number);
  }
  return own / fmt::format("{}-{}.resect", exercise, last + 1);
}

fs::path historyIn(const fs::path& folder) { return folder / "scores.sqlite"; }

std::vector<HistoryEntry> attemptsOf(const fs::path& folder, const std::string& learner) {
  std::error_code ec;
  if (!fs::exists(historyIn(folder), ec)) return {};
  return LearnerHistory(historyIn(folder)).entries(learner);
}

}  // namespace resect

#include "skills/class/class_book.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "skills/score/findings.h"

namespace resect {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Whether a comes before b, numbers in them counting as numbers.
bool naturallyBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      std::size_t endA = i, endB = j;
      while (endA < a.size() && isDigit(a[endA])) ++endA;
      while (endB < b.size() && isDigit(b[endB])) ++endB;
      while (i < endA && a[i] == '0') ++i;
      while (j < endB && b[j] == '0') ++j;
      if (endA - i != endB - j) return endA - i < endB - j;
      const int order = a.compare(i, endA - i, b, j, endB - j);
      if (order != 0) return order < 0;
      i = endA, j = endB;
    } else if (a[i] != b[j]) {
      return a[i] < b[j];
    } else {
      ++i, ++j;
    }
  }
  return a.size() - i < b.size() - j;
}

// "anna" of "anna-2" and "anna 12".
std::string learnerOf(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const std::filesystem::path inside = file.lexically_relative(folder);
  if (inside.has_parent_path()) return inside.begin()->string();
  std::string name = file.stem().string();
  while (!name.empty() && isDigit(name.back())) name.pop_back();
  while (!name.empty() && (name.back() == '-' || name.back() == '_' || name.back() == ' '))
    name.pop_back();
  return name.empty() ? file.stem().string() : name;
}

}  // namespace

ClassAttempt classAttempt(const Scored& scored) {
  ClassAttempt one{scored.attempt.file,
                   scored.verdict.passed,
                   scored.verdict.graded,
                   scored.verdict.goal.reached,
                   scored.verdict.score,
                   scored.verdict.reason,
                   {},
                   scored.verdict.checks,
                   scored.attempt.undos,
                   scored.level};
  for (const Measured& m : scored.measures)
    if (m.instrument.empty()) one.measures.push_back(m);
  return one;
}

std::vector<ClassFile> classFiles(const std::filesystem::path& folder) {
  std::error_code ec;
  if (!std::filesystem::is_directory(folder, ec))
    throw error("{}: is no folder; name the folder that holds the class's recordings",
                folder.string());
  std::vector<ClassFile> files;
  for (auto at = std::filesystem::recursive_directory_iterator(folder, ec);
       at != std::filesystem::recursive_directory_iterator(); at.increment(ec)) {
    if (ec) throw error("{}: cannot be read ({})", folder.string(), ec.message());
    if (at->path().extension() != ".resect" || !at->is_regular_file(ec)) continue;
    const std::string name = learnerOf(at->path(), folder);
    files.push_back({at->path(), name, name});
  }
  if (files.empty())
    throw error("{}: holds no recordings (.resect); copy the learners' recordings into it",
                folder.string());
  std::ranges::sort(files, [](const ClassFile& a, const ClassFile& b) {
    if (a.learner != b.learner) return naturallyBefore(a.learner, b.learner);
    return naturallyBefore(a.path.string(), b.path.string());
  });
  return files;
}

void usePseudonyms(std::vector<ClassFile>& files) {
  std::map<std::string, std::string> names;
  for (ClassFile& file : files) {
    const auto [at, fresh] = names.try_emplace(file.learner, "");
    if (fresh) at->second = fmt::format("learner {}", names.size());
    file.learner = at->second;
  }
}

std::vector<CheckDifficulty> difficulties(const TaskCourse& task) {
  std::vector<CheckDifficulty> all{{"", 0, 0}};
  for (const LearnerCourse& learner : task.learners)
    for (const ClassAttempt& one : learner.attempts) {
      if (!one.graded) continue;
      ++all[0].attempts;
      all[0].kept += one.goalReached;
      for (const Check& check : one.checks) {
        if (check.kept && !one.goalReached && addsUp(check.measure)) continue;
        auto at = std::ranges::find(all, check.measure, &CheckDifficulty::measure);
        if (at == all.end()) at = all.insert(all.end(), {check.measure, 0, 0});
        ++at->attempts;
        at->kept += check.kept;
      }
    }
  return all;
}

std::vector<bool> passes(const LearnerCourse& course) {
  std::vector<bool> passed;
  for (const ClassAttempt& one : course.attempts)
    if (one.graded) passed.push_back(one.passed);
  return passed;
}

}  // namespace resect

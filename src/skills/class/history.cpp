#include "skills/class/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/state/field_hashes.h"
#include "io/whole_file.h"
#include "record/file/recording_file.h"

namespace resect {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kApplication = 0x52534348;  // "RSCH", shown by `file`

std::string digestOf(const std::string& bytes) {
  return fmt::format("{:016x}", fastHash(bytes.data(), bytes.size()));
}

Json toJson(const ClassAttempt& one) {
  Json json{{"file", one.file},   {"passed", one.passed}, {"goal_reached", one.goalReached},
            {"score", one.score}, {"reason", one.reason}, {"undos", one.undos}};
  json["graded"] = one.graded, json["level"] = wordOf(one.level);
  for (const Measured& m : one.measures) json["measures"][m.measure] = m.value;
  json["checks"] = Json::array();
  for (const Check& c : one.checks)
    json["checks"].push_back(
        {{"measure", c.measure}, {"value", c.value ? Json(*c.value) : Json()}, {"kept", c.kept}});
  return json;
}

ClassAttempt fromJson(const Json& json) {
  ClassAttempt one;
  one.file = json.at("file"), one.passed = json.at("passed");
  one.goalReached = json.at("goal_reached"), one.score = json.at("score");
  one.reason = json.at("reason"), one.undos = json.at("undos");
  one.graded = json.value("graded", true);  // histories of older versions lack these two
  one.level = taskLevel(json.value("level", "")).value_or(TaskLevel::Medium);
  if (json.contains("measures"))
    for (const auto& [name, value] : json.at("measures").items())
      one.measures.push_back({name, "", value.get<double>()});
  for (const Json& c : json.at("checks")) {
    Check check;
    check.measure = c.at("measure"), check.kept = c.at("kept");
    if (!c.at("value").is_null()) check.value = c.at("value").get<double>();
    one.checks.push_back(std::move(check));
  }
  return one;
}

// The columns of a row: key, learner, scenario, title, written, familiarisation, attempt.
HistoryEntry entryOf(const Statement& row, const std::string& file) {
  HistoryEntry entry{row.text(0),    row.text(1),         row.text(2), row.text(3),
                     row.integer(4), row.integer(5) != 0, {}};
  try {
    entry.attempt = fromJson(Json::parse(row.text(6)));
  } catch (const Json::exception&) {
    throw error("{}: an entry of it is damaged; take an earlier copy of it, or delete the file",
                file);
  }
  return entry;
}

}  // namespace

std::string scoreKey(const std::filesystem::path& recording, const std::optional<Task>& task,
                     const std::optional<TaskLevel>& level) {
  std::string log;  // of a recording that was never ended
  const auto files = filesOfRecording(recording);
  std::error_code ec;
  if (std::filesystem::is_regular_file(files[1], ec)) log = readWholeFile(files[1]);
  return fmt::format("{}-{}-{}-{}-{}", digestOf(readWholeFile(recording)), digestOf(log),
                     task ? digestOf(task->text) : "own", level ? wordOf(*level) : "own",
                     kScoringVersion);
}

std::int64_t writtenAt(const std::filesystem::path& recording) {
  const auto time = std::chrono::file_clock::to_sys(std::filesystem::last_write_time(recording));
  return std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
}

HistoryEntry historyEntry(const Scored& scored, std::string key) {
  const Attempt& attempt = scored.attempt;
  return {std::move(key),      attempt.learner,         attempt.scenario,
          attempt.title,       writtenAt(attempt.file), attempt.task->familiarisation,
          classAttempt(scored)};
}

LearnerHistory::LearnerHistory(const std::filesystem::path& path) : database_(path, path.string()) {
  const std::int64_t application = database_.number("PRAGMA application_id");
  const std::int64_t tables = database_.number("SELECT count(*) FROM sqlite_master");
  if (application != kApplication && tables > 0)
    throw error("{}: is a database of another kind; give the name of a history, or a new one",
                path.string());
  database_.run(fmt::format(
      "PRAGMA application_id = {}; PRAGMA secure_delete = ON; "
      "CREATE TABLE IF NOT EXISTS attempt (key TEXT, learner TEXT, scenario TEXT, title TEXT, "
      "written INTEGER, familiarisation INTEGER, score TEXT, PRIMARY KEY (key, learner));",
      kApplication));
}

void LearnerHistory::keep(const HistoryEntry& entry) {
  Statement(database_, "INSERT OR REPLACE INTO attempt VALUES (?, ?, ?, ?, ?, ?, ?)")
      .bind(0, std::string_view(entry.key))
      .bind(1, std::string_view(entry.learner))
      .bind(2, std::string_view(entry.scenario))
      .bind(3, std::string_view(entry.title))
      .bind(4, entry.written)
      .bind(5, std::int64_t(entry.familiarisation))
      .bind(6, std::string_view(
                   toJson(entry.attempt).dump(-1, ' ', false, Json::error_handler_t::replace)))
      .run();
}

std::optional<HistoryEntry> LearnerHistory::find(const std::string& key,
                                                 const std::string& learner) {
  Statement row(database_, "SELECT * FROM attempt WHERE key = ? AND learner = ?");
  row.bind(0, std::string_view(key)).bind(1, std::string_view(learner));
  if (!row.step()) return {};
  return entryOf(row, database_.name());
}

std::vector<HistoryEntry> LearnerHistory::entries(const std::string& learner) {
  Statement row(database_,
                "SELECT * FROM attempt WHERE ?1 = '' OR learner = ?1 "
                "ORDER BY learner, scenario, written, key");
  row.bind(0, std::string_view(learner));
  std::vector<HistoryEntry> all;
  while (row.step()) all.push_back(entryOf(row, database_.name()));
  return all;
}

bool LearnerHistory::hasTried(const std::string& learner, const std::string& scenario) {
  return std::ranges::any_of(entries(learner), [&](const HistoryEntry& entry) {
    return entry.learner == learner && entry.scenario == scenario;
  });
}

std::int64_t LearnerHistory::remove(const std::string& learner) {
  Statement(database_, "DELETE FROM attempt WHERE learner = ?")
      .bind(0, std::string_view(learner))
      .run();
  const std::int64_t count = database_.number("SELECT changes()");
  database_.run("VACUUM");
  return count;
}

}  // namespace resect

// resect report: scores attempts at a task, and writes the debrief.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <ostream>

#include "app/exercise/attempt_folder.h"
#include "app/exercise/report_pdf.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/state/field_hashes.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/debrief/key_pictures.h"
#include "cli/debrief/record_store.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "formats/meshes/word_reader.h"
#include "io/output/atomic_file.h"
#include "io/output/output_target.h"
#include "io/output/run_files.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/task_files.h"
#include "io/whole_file.h"
#include "skills/attempt/read_attempt.h"
#include "skills/class/history.h"
#include "skills/exchange/xapi.h"
#include "skills/report/debrief.h"
#include "skills/report/report_json.h"
#include "skills/score/findings.h"
#include "skills/score/verdict.h"

namespace resect {
namespace {

struct ReportOptions {
  std::vector<std::string> files;
  std::string output, json, csv, samples, xapi, lrs, history, task, level, learner;
  std::string known;  // a history that is only read; "": none
  std::vector<std::string> references;
  int threads = 0;
  bool graded = false, plain = false;
};

std::optional<TaskLevel> levelOf(const ReportOptions& options) {
  if (options.level.empty()) return {};
  const auto level = taskLevel(options.level);
  if (!level) throw usageError("--level is \"{}\"; use easy, medium or hard", options.level);
  return level;
}

std::vector<std::filesystem::path> inputsOf(const ReportOptions& options) {
  std::vector<std::filesystem::path> inputs;
  const auto add = [&](const std::string& file) {
    for (const auto& part : filesOfRecording(file)) inputs.push_back(part);
  };
  for (const std::string& file : options.files) add(file);
  for (const std::string& file : options.references) add(file);
  return inputs;
}

AttemptOptions attemptOptions(const ReportOptions& options) {
  AttemptOptions attempt;
  attempt.learner = options.learner;
  if (options.task.empty()) return attempt;
  const Scenario scenario = readScenario(findScenario(options.task));
  if (!scenario.task) throw error("{}: has no task; name a scenario that has one", scenario.file);
  attempt.task = scenario.task;
  return attempt;
}

Scored scoredFile(const std::string& file, const ReportOptions& options, bool graded) {
  Attempt attempt = readAttempt(file, attemptOptions(options), progressBar(file));
  if (!attempt.task)
    throw error(
        "{}: was recorded without a task, so there is nothing to score it by; name one by --task",
        file);
  return score(std::move(attempt), levelOf(options), graded);
}

void keepHistory(const ReportOptions& options, const std::vector<Scored>& attempts) {
  LearnerHistory history(options.history);
  const std::optional<Task> task = attemptOptions(options).task;
  for (const Scored& one : attempts)
    history.keep(historyEntry(one, scoreKey(one.attempt.file, task, levelOf(options))));
}

// The history that the window keeps above the folders of its learners, if the recording lies in one
// and no other history is named; and the learner then. So both say the same of an attempt.
void useHistoryBeside(ReportOptions& options) {
  if (!options.history.empty() || options.files.empty()) return;
  const std::filesystem::path folder =
      std::filesystem::absolute(options.files.back()).parent_path();
  const std::filesystem::path history = historyIn(folder.parent_path());
  std::error_code none;
  if (!std::filesystem::is_regular_file(history, none)) return;
  options.known = history.string();
  if (options.learner.empty()) options.learner = folder.filename().string();
}

// What the history tells of the attempts' task besides them: of this learner, and of the others.
struct Known {
  std::vector<ClassAttempt> earlier, others;
  std::optional<bool> graded;  // the first of the attempts, when it was scored before
};
Known knownOf(const ReportOptions& options, const std::vector<Scored>& attempts) {
  Known known;
  const std::string& file = options.history.empty() ? options.known : options.history;
  if (file.empty()) return known;
  const std::optional<Task> task = attemptOptions(options).task;
  std::vector<std::string> reported;
  for (const Scored& one : attempts)
    reported.push_back(scoreKey(one.attempt.file, task, levelOf(options)));
  const Attempt& last = attempts.back().attempt;
  for (HistoryEntry& entry : LearnerHistory(file).entries()) {
    if (entry.scenario != last.scenario) continue;
    const bool own = entry.learner == last.learner;
    if (own && std::ranges::count(reported, entry.key) > 0) {
      if (entry.key == reported.front()) known.graded = entry.attempt.graded;
      continue;
    }
    // The entries of a learner come in the order of time: what follows was done later.
    if (own && !options.known.empty() && known.graded) continue;
    (own ? known.earlier : known.others).push_back(std::move(entry.attempt));
  }
  if (!known.earlier.empty() && last.task->familiarisation && !options.graded)
    known.earlier.front().graded = false;
  return known;
}

// The time of an attempt is that at which its recording was last written.
XapiContext xapiContext(const ReportOptions& options, const Scored& scored) {
  XapiContext context;
  if (!options.learner.empty()) context.actor = options.learner;
  const auto written = std::filesystem::last_write_time(scored.attempt.file);
  context.time = std::chrono::time_point_cast<std::chrono::system_clock::duration>(
      std::chrono::file_clock::to_sys(written));
  const std::string bytes = readWholeFile(scored.attempt.file);
  context.identity = fmt::format("{:016x}", fastHash(bytes.data(), bytes.size()));
  return context;
}

// Sent last, so that nothing is lost if the store does not answer.
void send(const ReportOptions& options, const nlohmann::ordered_json& statements) {
  const char* key = std::getenv("RESECT_LRS_KEY");
  const bool taken = sendStatements(options.lrs, statements.dump(), key ? key : "");
  printLine(stderr, "{}: {}", options.lrs,
            taken ? "took the statements" : "had the statements already");
}

// Of the moments to which the deductions point. A machine that cannot draw is no reason to do
// without the debrief.
KeyMoments momentsOf(const Scored& scored) {
  std::vector<std::optional<double>> times;
  for (const Deduction& d : scored.verdict.deductions) times.push_back(d.time);
  try {
    return keyMoments(scored.attempt.file, times, progressBar("pictures"));
  } catch (const Error& e) {
    printLine(stderr, "note: no pictures: {}", shownSentence(e.what()));
    return {};
  }
}

bool isPdf(const std::string& file) {
  return lowerCase(std::filesystem::path(file).extension().string()) == ".pdf";
}

void printSummary(std::FILE* to, const Scored& s) {
  printLine(to, "{}: {}", s.attempt.file, s.attempt.title);
  printLine(to, "  {}{}, score {:.0f} %: {}", s.verdict.passed ? "passed" : "failed",
            s.verdict.graded ? "" : " (first attempt, for practice: does not count)",
            100 * s.verdict.score, s.verdict.reason);
  for (const Deduction& d : s.verdict.deductions)
    printLine(to, "  {:>7}  {}", d.time ? timeText(*d.time) : "", d.fact);
}

void reportOn(ReportOptions options) {
  useHistoryBeside(options);
  const ThreadLimit threads(options.threads);
  checkOutputs({{{"--output", options.output},
                 {"--json", options.json},
                 {"--csv", options.csv},
                 {"--samples", options.samples},
                 {"--xapi", options.xapi}}},
               inputsOf(options));
  std::vector<Scored> attempts;
  for (const std::string& file : options.files) attempts.push_back(scoredFile(file, options, true));
  const Known known = knownOf(options, attempts);
  if (!options.known.empty() && known.graded && !options.graded)
    attempts.front().verdict.graded = *known.graded;
  else if (known.earlier.empty() && !options.graded)
    attempts.front().verdict.graded = !attempts.front().attempt.task->familiarisation;
  std::vector<Scored> references;
  for (const std::string& file : options.references)
    references.push_back(scoredFile(file, options, true));

  if (!options.history.empty()) keepHistory(options, attempts);
  if (!options.csv.empty())
    writeCsvFile(options.csv, [&](CsvWriter& csv) { writeAttemptRows(csv, attempts); });
  if (!options.samples.empty())
    writeCsvFile(options.samples,
                 [&](CsvWriter& csv) { writeSampleRows(csv, attempts.back().attempt); });
  if (!options.json.empty()) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Scored& one : attempts) all.push_back(toJson(one));
    writeJson(options.json, all);
  }
  nlohmann::ordered_json statements;
  if (!options.xapi.empty() || !options.lrs.empty())
    statements = xapiStatements(attempts.back(), xapiContext(options, attempts.back()));
  if (!options.xapi.empty()) writeJson(options.xapi, statements);
  if (!options.output.empty()) {
    Debrief debrief{attempts, references, known.earlier, known.others};
    for (const std::string& band : attempts.back().attempt.task->published)
      debrief.studies.push_back(readPublishedStudy(band));
    if (!options.plain) {
      KeyMoments moments = momentsOf(attempts.back());
      debrief.pictures = std::move(moments.pictures);
      debrief.clip = std::move(moments.clip);
    }
    std::string page = debriefPage(debrief);
    if (isPdf(options.output)) page = reportPdf(page, attempts.back().attempt.title);
    writeFileAtomically(options.output, [&](std::ostream& out) { out << page; });
  }
  if (!isStandardOutput(options.json)) {
    std::FILE* text = placeForText({options.output, options.csv, options.samples, options.xapi});
    for (const Scored& one : attempts) printSummary(text, one);
  }
  if (!options.lrs.empty()) send(options, statements);
}

}  // namespace

void addReportCommand(Command app) {
  auto options = std::make_shared<ReportOptions>();
  Command command = app.subcommand("report", "Score recorded attempts at a task: the debrief");
  command
      .option("FILE", options->files,
              "Recordings (.resect) of one learner, the oldest first; the report is about the "
              "last one")
      .required();
  command.option("-o,--output", options->output,
                 "The debrief as an HTML page (.html), or as PDF (.pdf)");
  command.option("--json", options->json, "JSON file; - for standard output");
  command.option("--csv", options->csv, "CSV file with a row for each attempt");
  command.option("--samples", options->samples,
                 "CSV file with a row for each frame and instrument of the last attempt");
  command.option("--xapi", options->xapi,
                 "File for xAPI 1.0.3 statements about the last attempt (.json)");
  command.option("--history", options->history,
                 "SQLite file that keeps the scores of the learner; see resect history");
  command.option("--lrs", options->lrs,
                 "Learning record store to send these statements to: the URL of its xAPI "
                 "endpoint; the environment's RESECT_LRS_KEY has \"key:secret\"");
  command.option("--task", options->task,
                 "Scenario whose task to score by, instead of the recording's own");
  command.option("--level", options->level, "easy, medium or hard, instead of the task's own");
  command.option("--learner", options->learner, "Pseudonym of the learner");
  command.option("--reference", options->references, "Recordings to compare with");
  command.flag("--no-pictures", options->plain,
               "Leave out the pictures of the moments to which the debrief points");
  command.flag("--graded", options->graded,
               "Grade the first attempt too, where the task takes it for familiarisation");
  addThreadsOption(command, options->threads);
  command.footer(
      "Examples:\n  resect run control-bleeding --record mine.resect\n"
      "  resect report mine.resect -o report.html");
  command.action([options] { reportOn(*options); });
}

}  // namespace resect

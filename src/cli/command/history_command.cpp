// resect history: what learners did, from the SQLite file that report and class keep.

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "formats/export/csv_file.h"
#include "io/output/run_files.h"
#include "operation/task/measure.h"
#include "skills/class/history.h"
#include "skills/report/report_json.h"

namespace resect {
namespace {

struct HistoryOptions {
  std::string file, learner, csv;
  bool remove = false;
};

std::string dayOf(std::int64_t written) {
  return fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(std::time_t(written)));
}

void writeRows(CsvWriter& csv, const std::vector<HistoryEntry>& entries) {
  csv.cell("learner").cell("task").cell("written_utc").cell("passed").cell("score");
  csv.cell("reason");
  for (const MeasureKind& kind : measureKinds()) csv.cell(kind.id);
  csv.end();
  for (const HistoryEntry& entry : entries) {
    csv.cell(entry.learner).cell(entry.scenario).cell(dayOf(entry.written));
    csv.cell(std::string_view(entry.attempt.passed ? "yes" : "no"));
    csv.cell(printed(entry.attempt.score)).cell(entry.attempt.reason);
    for (const MeasureKind& kind : measureKinds()) {
      if (const auto value = valueOf(entry.attempt.measures, kind.id))
        csv.cell(printed(*value));
      else
        csv.empty();
    }
    csv.end();
  }
}

void history(const HistoryOptions& options) {
  if (!std::filesystem::exists(options.file))
    throw error("{}: there is no such file; report and class keep one if --history names it",
                options.file);
  if (options.remove && options.learner.empty())
    throw usageError("--delete needs --learner: the one whose attempts are to be deleted");
  checkOutputs({{{"--csv", options.csv}}}, std::vector<std::filesystem::path>{options.file});
  LearnerHistory history(options.file);
  const std::vector<HistoryEntry> entries = history.entries(options.learner);
  if (!options.csv.empty())
    writeCsvFile(options.csv, [&](CsvWriter& csv) { writeRows(csv, entries); });
  if (options.remove) {
    printLine(stdout, "{}: {} attempts of {} deleted", options.file,
              history.remove(options.learner), options.learner);
    return;
  }
  for (const HistoryEntry& entry : entries)
    printLine(stdout, "{:<20} {:<20} {}  {:<7} {:3.0f} %  {}", entry.learner, entry.scenario,
              dayOf(entry.written), entry.attempt.passed ? "passed" : "failed",
              100 * entry.attempt.score, entry.attempt.reason);
}

}  // namespace

void addHistoryCommand(Command app) {
  auto options = std::make_shared<HistoryOptions>();
  Command command = app.subcommand("history", "Show, export or delete what learners did");
  command
      .option("FILE", options->file,
              "History (.sqlite) that report or class have kept with --history")
      .required();
  command.option("--learner", options->learner, "Only this learner");
  command.option("--csv", options->csv, "CSV file with a row for each attempt");
  command.flag("--delete", options->remove, "Delete all attempts of --learner");
  command.footer(
      "Examples:\n  resect report mine.resect --learner L-17 --history mine.sqlite\n"
      "  resect history mine.sqlite --csv mine.csv\n"
      "  resect history mine.sqlite --learner L-17 --delete");
  command.action([options] { history(*options); });
}

}  // namespace resect

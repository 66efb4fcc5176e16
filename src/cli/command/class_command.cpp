// resect class: the recordings of a class in a folder, scored: who passed what, learning curves.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/progress_bar.h"
#include "io/output/atomic_file.h"
#include "io/output/run_files.h"
#include "record/file/recording_file.h"
#include "skills/attempt/read_attempt.h"
#include "skills/class/class_page.h"
#include "skills/class/history.h"

namespace resect {
namespace {

struct ClassOptions {
  std::string folder, output, history;
  bool names = false, graded = false;
  LearningTest test;
};

TaskCourse& courseOfTask(ClassBook& book, const HistoryEntry& entry) {
  const auto at = std::ranges::find(book.tasks, entry.scenario, &TaskCourse::scenario);
  if (at != book.tasks.end()) return *at;
  return book.tasks.emplace_back(TaskCourse{entry.scenario, entry.title, {}});
}

LearnerCourse& courseOfLearner(TaskCourse& task, const std::string& learner) {
  const auto at = std::ranges::find(task.learners, learner, &LearnerCourse::learner);
  if (at != task.learners.end()) return *at;
  return task.learners.emplace_back(LearnerCourse{learner, {}});
}

// The score of a recording: from the history if it is there, else made now and kept there.
HistoryEntry scoreOf(const ClassFile& file, LearnerHistory* history) {
  const std::string key = scoreKey(file.path, {}, {});
  if (history)
    if (auto known = history->find(key, file.name)) return *known;
  AttemptOptions options;
  options.learner = file.name;
  Attempt attempt = readAttempt(file.path, options, progressBar(file.path.string()));
  if (!attempt.task) throw error("{}: was recorded without a task", file.path.string());
  HistoryEntry entry = historyEntry(score(std::move(attempt)), key);
  if (history) history->keep(entry);
  return entry;
}

void add(ClassBook& book, const ClassFile& file, const ClassOptions& options,
         LearnerHistory* history) {
  const HistoryEntry entry = scoreOf(file, history);
  LearnerCourse& course = courseOfLearner(courseOfTask(book, entry), file.learner);
  const bool first = course.attempts.empty();
  course.attempts.push_back(entry.attempt);
  course.attempts.back().graded = !(first && entry.familiarisation && !options.graded);
  if (!options.names) course.attempts.back().file.clear();  // it may hold the learner's name
}

void printSummary(const ClassBook& book) {
  for (const TaskCourse& task : book.tasks) {
    printLine(stdout, "{}: {}", task.scenario, task.title);
    for (const LearnerCourse& course : task.learners) {
      const std::vector<bool> passed = passes(course);
      printLine(stdout, "  {:<20} {} attempts, {} of {} graded ones passed", course.learner,
                course.attempts.size(), std::ranges::count(passed, true), passed.size());
    }
  }
}

void classTable(const ClassOptions& options) {
  const std::string extension = std::filesystem::path(options.output).extension().string();
  if (!options.output.empty() && extension != ".html" && extension != ".csv")
    throw usageError("--output is \"{}\"; give a name that ends in .html or .csv", options.output);
  learningCusum({}, options.test);  // refuses settings that are wrong
  std::vector<ClassFile> files = classFiles(options.folder);
  std::vector<std::filesystem::path> inputs;
  for (const ClassFile& file : files)
    for (const auto& part : filesOfRecording(file.path)) inputs.push_back(part);
  checkOutputs({{{"--output", options.output}}}, inputs);
  if (!options.names) usePseudonyms(files);

  std::optional<LearnerHistory> history;
  if (!options.history.empty()) history.emplace(options.history);
  ClassBook book;
  book.name = std::filesystem::weakly_canonical(options.folder).filename().string();
  for (const ClassFile& file : files) {
    try {
      add(book, file, options, history ? &*history : nullptr);
    } catch (const Error& e) {
      printLine(stderr, "note: {}", shownSentence(e.what()));
      book.refused.push_back(options.names ? e.what() : "A recording of " + file.learner + ".");
    }
  }
  if (book.tasks.empty())
    throw error("{}: holds no recording that could be scored; record attempts at a task",
                options.folder);
  if (extension == ".html")
    writeFileAtomically(options.output,
                        [&](std::ostream& out) { out << classPage(book, options.test); });
  if (extension == ".csv")
    writeCsvFile(options.output, [&](CsvWriter& csv) { writeClassRows(csv, book, options.test); });
  printSummary(book);
}

}  // namespace

void addClassCommand(Command app) {
  auto options = std::make_shared<ClassOptions>();
  Command command = app.subcommand("class", "Score the recordings of a class: who passed what");
  command
      .option("FOLDER", options->folder,
              "Folder of recordings: a sub-folder for each learner, or names as anna-2.resect")
      .required();
  command.option("-o,--output", options->output, "Page (.html) or table (.csv)");
  command.option("--history", options->history,
                 "SQLite file that keeps the scores, with the learners' names: a recording is "
                 "then scored only once");
  command.flag("--names", options->names, "Show the learners' names instead of pseudonyms");
  command.flag("--graded", options->graded, "Grade first attempts too");
  command
      .option("--inadequate", options->test.inadequate,
              "LC-CUSUM: failure rate of a learner who is not competent")
      .showDefault();
  command
      .option("--adequate", options->test.adequate,
              "LC-CUSUM: failure rate of one who is competent")
      .showDefault();
  command.option("--signal", options->test.signal, "LC-CUSUM: where the curve shows competence")
      .showDefault();
  command.footer("Example:\n  resect class autumn -o autumn.html");
  command.action([options] { classTable(*options); });
}

}  // namespace resect

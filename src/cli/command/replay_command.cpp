// resect replay: plays a recording, or a part of it, and draws it.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/text/printed_time.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/ledger_report.h"
#include "cli/picture_writer.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "io/output/output_target.h"
#include "io/output/run_files.h"
#include "record/export/moments.h"
#include "record/replay.h"

namespace resect {
namespace {

struct ReplayOptions {
  std::string file, json;
  PictureOptions pictures;
  RecordedPart part;
  bool events = false, overwrite = false;
};

nlohmann::ordered_json toJson(const OperationEvent& event, const RecordedSetup& setup) {
  nlohmann::ordered_json json{
      {"frame", event.frame}, {"time_s", printedTime(event.time)}, {"kind", event.kind}};
  if (const std::string tool = toolName(setup, event.tool); !tool.empty()) json["tool"] = tool;
  if (event.amount != 0) json["amount"] = event.amount;
  if (!event.text.empty()) json["text"] = event.text;
  return json;
}

// "cut 12 Scalpel"
std::string lineOf(const OperationEvent& event, const RecordedSetup& setup) {
  std::string line = event.kind;
  if (event.amount != 0) line += fmt::format(" {}", event.amount);
  if (const std::string tool = toolName(setup, event.tool); !tool.empty()) line += " " + tool;
  return event.text.empty() ? line : line + ": " + event.text;
}

void play(const ReplayOptions& options) {
  options.part.check();
  options.pictures.check();
  if (options.pictures.wanted() || !options.json.empty())
    checkOutputs({{{"--video", options.pictures.video}, {"--json", options.json}},
                  {framesIn(options.pictures.frames)},
                  options.overwrite},
                 filesOfRecording(options.file));
  Replay replay(options.file);
  Scenario scenario = replay.setup().scenario;
  options.pictures.applyTo(scenario);
  const std::vector<CourseSpan> course = options.part.of(replay.file(), scenario.frameRate);
  const std::int64_t branch = options.part.branchIn(replay.file());
  const std::int64_t first = course[0].first;
  replay.goTo(course[0].branch, first);

  std::optional<PictureWriter> pictures;
  if (options.pictures.wanted())
    pictures.emplace(scenario, replay.simulation(),
                     settingsOf(options.pictures, options.overwrite));
  std::vector<double> forces(scenario.tools.size(), 0);  // largest on each tool, N
  playMoments(
      replay, {course, options.pictures.rate}, false, [](const Simulation&) {},
      progressBar("replay"),
      [&](const StepReport& step) {
        for (std::size_t t = 0; t < std::min(forces.size(), step.toolForce.size()); ++t)
          forces[t] = std::max(forces[t], step.toolForce[t].norm());
        if (pictures) pictures->follow(replay.simulation(), step);
      });
  std::vector<OperationEvent> events;
  for (const CourseSpan& span : course)
    for (OperationEvent& event : replay.file().events(span.branch))
      if (event.frame > span.first && event.frame <= span.last) events.push_back(std::move(event));
  std::vector<std::string> files;
  if (pictures) files = pictures->finish();

  const Simulation& now = replay.simulation();
  const Ledger ledger = LedgerBooks(scenario, now).ledgerOf(now);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  nlohmann::ordered_json peaks = nlohmann::ordered_json::array();
  std::string felt;
  for (std::size_t t = 0; t < forces.size(); ++t) {
    const std::string tool = toolName(replay.setup(), std::int64_t(t));
    peaks.push_back({{"tool", tool}, {"peak", forces[t]}});
    if (forces[t] > 0)
      felt += fmt::format("{}{} {:.2f} N", felt.empty() ? "" : ", ", shownText(tool), forces[t]);
  }
  for (const OperationEvent& event : events) list.push_back(toJson(event, replay.setup()));
  if (!options.json.empty())
    writeJson(options.json, {{"file", options.file},
                             {"title", scenario.title},
                             {"program", replay.file().info().program},
                             {"branch", branch},
                             {"from_frame", first},
                             {"to_frame", now.frame()},
                             {"time_s", printedTime(now.time())},
                             {"complete", replay.file().complete()},
                             {"events", list},
                             {"tool_forces_n", peaks},
                             {"ledger", toJson(ledger)},
                             {"state_hash", fmt::format("{:016x}", now.stateHash())}});
  if (isStandardOutput(options.json)) return;
  printLine(stdout, "{}: {}", options.file,
            scenario.title.empty() ? scenario.name : scenario.title);
  fmt::print("  recorded by {}, {:.1f} s at {:g} frames/s{}\n",
             shownText(replay.file().info().program),
             double(replay.file().lastFrame(branch)) / scenario.frameRate, scenario.frameRate,
             replay.file().complete() ? "" : "; the program ended before the recording did");
  for (const Branch& one : replay.file().branches())
    fmt::print(
        "  branch {} \"{}\"{}: {} frames{}\n", one.number, shownText(one.name),
        one.number == branch ? ", played" : "",
        std::max<std::int64_t>(0, replay.file().lastFrame(one.number) - one.from),
        one.parent < 0 ? "" : fmt::format(", from frame {} of branch {}", one.from, one.parent));
  if (options.events && events.empty()) fmt::print("  no events in these frames\n");
  if (options.events)
    for (const OperationEvent& event : events)
      printLine(stdout, "  {:8.2f} s  frame {:6}  {}", event.time, event.frame,
                lineOf(event, replay.setup()));
  fmt::print("{}", toText(ledger));
  if (!felt.empty()) fmt::print("  {:<10} at most {}\n", "forces", felt);
  fmt::print("  played frames {} to {}, state {:016x}\n", first, now.frame(), now.stateHash());
  for (const std::string& file : files) fmt::print("  wrote {}\n", file);
}

}  // namespace

void addReplayCommand(Command app) {
  auto options = std::make_shared<ReplayOptions>();
  Command command = app.subcommand("replay", "Play a recorded operation, and draw it");
  addRecordingOption(command, options->file);
  addPartOptions(command, options->part);
  addOverwriteOption(command, options->overwrite,
                     "the numbered pictures of an earlier run from the folder of --frames");
  command.flag("--events", options->events, "List what happened, line by line");
  addPictureOptions(command, options->pictures);
  command.option("--json", options->json, "JSON file for the summary; - for standard output");
  command.footer(
      "Examples:\n  resect replay press.resect --events\n"
      "  resect replay press.resect --from 1 --to 2 --frames pictures");
  command.action([options] { play(*options); });
}

}  // namespace resect

// resect replay: plays a recording, or a part of it, and draws it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/picture_writer.h"
#include "cli/progress_bar.h"
#include "io/output/run_files.h"
#include "record/replay.h"

namespace resect {
namespace {

struct Options {
  std::string file, frames, video, json, size = "1280x720", view;
  double from = 0, to = INFINITY, pictureRate = 10;
  std::int64_t branch = -1;  // the last one
  bool events = false, overwrite = false;
};

nlohmann::ordered_json toJson(const OperationEvent& event, const Scenario& scenario) {
  nlohmann::ordered_json json{{"frame", event.frame}, {"time_s", event.time}, {"kind", event.kind}};
  if (event.tool >= 0 && std::size_t(event.tool) < scenario.tools.size())
    json["tool"] = scenario.tools[std::size_t(event.tool)].model;
  if (event.amount != 0) json["amount"] = event.amount;
  if (!event.text.empty()) json["text"] = event.text;
  return json;
}

// "cut 12 by scalpel"
std::string lineOf(const OperationEvent& event, const Scenario& scenario) {
  std::string line = event.kind;
  if (event.amount != 0) line += fmt::format(" {}", event.amount);
  if (event.tool >= 0 && std::size_t(event.tool) < scenario.tools.size())
    line +=
        " " + std::filesystem::path(scenario.tools[std::size_t(event.tool)].model).stem().string();
  return event.text.empty() ? line : line + ": " + event.text;
}

// A part of the course: frames of one branch, from the state `first` to `last`.
struct Span {
  std::int64_t branch, first, last;
};

// The frames that lead from the start to the end of a branch, through the branches before it.
std::vector<Span> courseOf(RecordingFile& file, std::int64_t branch) {
  const std::vector<Branch> branches = file.branches();
  std::vector<Span> course;
  std::int64_t end = file.lastFrame(branch);
  while (branch >= 0 && branch < std::int64_t(branches.size())) {
    const Branch& one = branches[std::size_t(branch)];
    if (end > one.from) course.insert(course.begin(), {branch, one.from, end});
    end = one.from;
    branch = one.parent < branch ? one.parent : -1;
  }
  return course;
}

void play(const Options& options) {
  if (!(options.from >= 0) || !(options.to >= options.from))
    throw usageError(
        "--from {} and --to {} are no span of time; give seconds from 0 on, the first "
        "not after the second",
        options.from, options.to);
  if (!options.frames.empty() || !options.video.empty() || !options.json.empty())
    checkOutputs({{{"--video", options.video}, {"--json", options.json}},
                  {framesIn(options.frames)},
                  options.overwrite},
                 std::vector<std::filesystem::path>{options.file});
  Replay replay(options.file);
  Scenario scenario = replay.setup().scenario;
  if (!options.view.empty()) {
    scenario.view = options.view;
    scenario.closeUp.reset();
  }
  const std::int64_t branch =
      options.branch < 0 ? std::int64_t(replay.file().branches().size()) - 1 : options.branch;
  std::vector<Span> course = courseOf(replay.file(), branch);
  if (course.empty())
    throw error("{}: has no frames in branch {}; leave --branch out", options.file, branch);
  const auto frameAt = [&](double time) {
    const double frame = time * scenario.frameRate;
    return frame < double(course.back().last) ? std::llround(frame) : course.back().last;
  };
  const std::int64_t first = frameAt(options.from), end = frameAt(options.to);
  std::erase_if(course, [&](const Span& s) { return s.last <= first && first < end; });
  std::erase_if(course, [&](const Span& s) { return s.first >= end && first < end; });
  replay.goTo(course[0].branch, std::clamp(first, course[0].first, course[0].last));

  std::optional<PictureWriter> pictures;
  if (!options.frames.empty() || !options.video.empty())
    pictures.emplace(scenario, replay.simulation(),
                     PictureSettings{options.frames, options.video, options.size,
                                     options.pictureRate, options.overwrite});
  const Progress progress = progressBar("replay");
  std::vector<OperationEvent> events;
  StepReport step;
  for (const Span& span : course) {
    if (replay.branch() != span.branch) replay.goTo(span.branch, span.first);
    const std::int64_t last = std::min(end, span.last), begin = replay.simulation().frame();
    while (replay.simulation().frame() < last && replay.step(nullptr, &step)) {
      if (pictures) pictures->follow(replay.simulation(), step);
      report(progress, double(replay.simulation().frame() - first) /
                           double(std::max<std::int64_t>(1, end - first)));
    }
    for (OperationEvent& event : replay.file().events(span.branch))
      if (event.frame > begin && event.frame <= last) events.push_back(std::move(event));
  }
  std::vector<std::string> files;
  if (pictures) files = pictures->finish();

  const Simulation& now = replay.simulation();
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const OperationEvent& event : events) list.push_back(toJson(event, scenario));
  if (!options.json.empty())
    writeJson(options.json, {{"file", options.file},
                             {"title", scenario.title},
                             {"program", replay.file().info().program},
                             {"branch", branch},
                             {"from_frame", first},
                             {"to_frame", now.frame()},
                             {"time_s", now.time()},
                             {"complete", replay.file().complete()},
                             {"events", list},
                             {"state_hash", fmt::format("{:016x}", now.stateHash())}});
  if (options.json == "-") return;
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
                lineOf(event, scenario));
  fmt::print("  played frames {} to {}, state {:016x}\n", first, now.frame(), now.stateHash());
  for (const std::string& file : files) fmt::print("  wrote {}\n", file);
}

}  // namespace

void addReplayCommand(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("replay", "Play a recorded operation, and draw it");
  command->add_option("FILE", options->file, "Recording (.resect)")->required();
  command->add_option("--from", options->from, "Where to begin, s")->capture_default_str();
  command->add_option("--to", options->to, "Where to end, s; without it at the recording's end");
  command->add_option("--branch", options->branch,
                      "Course of the operation, from its start; without it the one that was last");
  command->add_flag("--overwrite", options->overwrite,
                    "Remove the numbered pictures of an earlier run from the folder of --frames");
  command->add_flag("--events", options->events, "List what happened, line by line");
  command->add_option("--frames", options->frames, "Folder for numbered pictures (PNG)");
  command->add_option("--video", options->video,
                      "Video to make of the pictures (.mp4; needs ffmpeg)");
  command->add_option("--picture-rate", options->pictureRate, "Pictures per simulated second")
      ->check(CLI::Range(0.01, 1000.0))
      ->capture_default_str();
  command->add_option("--size", options->size, "Width and height of the pictures, pixels")
      ->capture_default_str();
  command->add_option("--view", options->view, "Camera: surgeon, assistant, top or laparoscope");
  command->add_option("--json", options->json, "JSON file for the summary; - for standard output");
  command->footer(
      "Examples:\n  resect replay press.resect --events\n"
      "  resect replay press.resect --from 1 --to 2 --frames pictures");
  command->callback([options] { play(*options); });
}

}  // namespace resect

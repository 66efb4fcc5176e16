// resect replay: plays a recording, or a part of it, and draws it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/picture_writer.h"
#include "cli/progress_bar.h"
#include "record/replay.h"

namespace resect {
namespace {

struct Options {
  std::string file, frames, video, json, size = "1280x720", view;
  double from = 0, to = INFINITY, pictureRate = 10;
  std::int64_t branch = 0;
  bool events = false;
};

nlohmann::ordered_json toJson(const RecordedEvent& event, const Scenario& scenario) {
  nlohmann::ordered_json json{{"frame", event.frame}, {"time_s", event.time}, {"kind", event.kind}};
  if (event.tool >= 0 && std::size_t(event.tool) < scenario.tools.size())
    json["tool"] = scenario.tools[std::size_t(event.tool)].model;
  if (event.amount != 0) json["amount"] = event.amount;
  if (!event.text.empty()) json["text"] = event.text;
  return json;
}

// The frame of the branch that ends at a time or just before it.
std::int64_t frameAt(double time, const Replay& replay, std::int64_t last) {
  if (!(time < double(last) / replay.setup().scenario.frameRate)) return last;
  return std::max<std::int64_t>(0, std::llround(time * replay.setup().scenario.frameRate));
}

void play(const Options& options) {
  if (!(options.from >= 0) || !(options.to >= options.from))
    throw usageError(
        "--from {} and --to {} are no span of time; give seconds from 0 on, the first "
        "not after the second",
        options.from, options.to);
  Replay replay(options.file);
  Scenario scenario = replay.setup().scenario;
  if (!options.view.empty()) {
    scenario.view = options.view;
    scenario.closeUp.reset();
  }
  const std::int64_t last = replay.file().lastFrame(options.branch);
  if (last < 0)
    throw error("{}: has no frames in branch {}; see resect replay {} --events", options.file,
                options.branch, options.file);
  const std::int64_t first = frameAt(options.from, replay, last),
                     end = frameAt(options.to, replay, last);
  replay.goTo(options.branch, first);

  std::optional<PictureWriter> pictures;
  if (!options.frames.empty() || !options.video.empty())
    pictures.emplace(
        scenario, replay.simulation(),
        PictureSettings{options.frames, options.video, options.size, options.pictureRate});
  const Progress progress = progressBar("replay");
  StepReport step;
  while (replay.simulation().frame() < end && replay.step(nullptr, &step)) {
    if (pictures) pictures->follow(replay.simulation(), step);
    report(progress, double(replay.simulation().frame() - first) /
                         double(std::max<std::int64_t>(1, end - first)));
  }
  std::vector<std::string> files;
  if (pictures) files = pictures->finish();

  const Simulation& now = replay.simulation();
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (const RecordedEvent& event : replay.file().events(options.branch))
    if (event.frame > first && event.frame <= now.frame())
      events.push_back(toJson(event, scenario));
  if (!options.json.empty())
    writeJson(options.json, {{"file", options.file},
                             {"title", scenario.title},
                             {"program", replay.file().info().program},
                             {"branch", options.branch},
                             {"from_frame", first},
                             {"to_frame", now.frame()},
                             {"time_s", now.time()},
                             {"complete", replay.file().complete()},
                             {"events", events},
                             {"state_hash", fmt::format("{:016x}", now.stateHash())}});
  if (options.json == "-") return;
  fmt::print("{}: {}\n  recorded by {}, {:.1f} s at {:g} frames/s{}\n", options.file,
             scenario.title, replay.file().info().program, double(last) / scenario.frameRate,
             scenario.frameRate,
             replay.file().complete() ? "" : "; the program ended before the recording did");
  for (const Branch& branch : replay.file().branches())
    fmt::print("  branch {} \"{}\": {} frames{}\n", branch.number, branch.name,
               std::max<std::int64_t>(0, replay.file().lastFrame(branch.number) - branch.from),
               branch.parent < 0
                   ? ""
                   : fmt::format(", from frame {} of branch {}", branch.from, branch.parent));
  if (options.events)
    for (const auto& event : events) fmt::print("  {}\n", event.dump());
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
  command->add_option("--branch", options->branch, "Course of the operation, if it has several")
      ->capture_default_str();
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

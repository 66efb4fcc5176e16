#include "cli/shared_options.h"

#include <fmt/format.h>

#include <cmath>

#include "base/error.h"
#include "formats/video.h"
#include "inventor/scene/operating_room.h"
#include "io/model.h"
#include "io/scenario/length.h"
#include "operation/setting_ranges.h"

namespace resect {

void PictureOptions::check() const {
  int width = 0, height = 0;
  parseSize(size, width, height);
  if (!view.empty() && !roomView(view))
    throw usageError("--view is \"{}\"; choose {}", view, kRoomViewNames);
  requireSetting(setting);
  requireQuality(quality);
  if (!std::isfinite(rate))
    throw usageError("--picture-rate is not a number; give pictures per second, 0.01 to 1000");
  if (!video.empty()) checkVideoFile(video);
}

void PictureOptions::applyTo(Scenario& scenario) const {
  if (!setting.empty()) scenario.setting = setting;
  if (view.empty()) return;
  scenario.view = view;
  scenario.closeUp.reset();  // of the scenario's own view
}

PictureSettings settingsOf(const PictureOptions& options, bool overwrite) {
  return {
      options.frames, options.video, options.size, options.rate, requireQuality(options.quality),
      options.hands,  overwrite};
}

void requireSetting(const std::string& setting) {
  if (!setting.empty() && !isSetting(setting))
    throw usageError("--setting is \"{}\"; choose {}", setting, kSettingNames);
}

PictureQuality requireQuality(const std::string& quality) {
  const std::optional<PictureQuality> known = pictureQuality(quality);
  if (!known) throw usageError("--quality is \"{}\"; choose {}", quality, kQualityNames);
  return *known;
}

void addQualityOption(Command command, std::string& quality) {
  command
      .option("--quality", quality,
              fmt::format("How carefully pictures are drawn: {}", kQualityNames))
      .showDefault();
}

void addSettingOption(Command command, std::string& setting) {
  command.option("--setting", setting,
                 "What stands round the organ: table, or field, an opened abdomen");
}

void addPictureOptions(Command command, PictureOptions& options) {
  command.option("--frames", options.frames, "Folder for numbered pictures (PNG)");
  command.option("--video", options.video, "Video to make of the pictures (.mp4; needs ffmpeg)");
  command.option("--picture-rate", options.rate, "Pictures per simulated second")
      .range(0.01, 1000.0)
      .showDefault();
  command.option("--size", options.size, "Width and height of the pictures, pixels").showDefault();
  addQualityOption(command, options.quality);
  command.option("--view", options.view, fmt::format("Camera: {}", kRoomViewNames));
  addSettingOption(command, options.setting);
  command.flag("!--no-hands", options.hands, "Draw no hands that hold the instruments");
}

void addBreathingOption(Command command, std::string& depth) {
  command.option(
      "--breathing", depth,
      "How far breathing moves the organs, as 10mm; 0mm: not at all. Needs elastic tissue");
}

void setBreathing(Scenario& scenario, const std::string& depth) {
  if (depth.empty()) return;
  const double metres = parseLength(depth, "--breathing");
  if (!ranges::kBreathDepth.holds(metres))
    throw usageError("--breathing is {}; give a length from {} to {}", depth,
                     lengthText(ranges::kBreathDepth.low), lengthText(ranges::kBreathDepth.high));
  setBreathing(scenario, metres);
}

void addThreadsOption(Command command, int& threads) {
  command.option("--threads", threads, "Threads to use; 0 = all. The result is the same")
      .range(0, 1024)
      .showDefault();
}

void addPartOption(Command command, std::string& part) {
  command
      .option(
          "--part,--label",
          [&part](const std::vector<std::string>& names) { part = partLines(names); },
          "Take only the part, or the label of an image, of that name; given several times, these "
          "parts, joined")
      .oneValueEach();
}

void addOverwriteOption(Command command, bool& overwrite, const std::string& numbered) {
  command.flag("--overwrite", overwrite, "Remove " + numbered);
}

void addRecordingOption(Command command, std::string& file) {
  command.option("FILE", file, "Recording (.resect)").required();
}

void RecordedPart::check() const {
  if (!(from >= 0) || !(to >= from))
    throw usageError(
        "--from {} and --to {} are no span of time; give seconds from 0 on, the first "
        "not after the second",
        from, to);
}

std::int64_t RecordedPart::branchIn(RecordingFile& file) const {
  return branch < 0 ? file.moment().branch : branch;
}

std::vector<CourseSpan> RecordedPart::of(RecordingFile& file, double frameRate) const {
  const std::vector<CourseSpan> course = courseOf(file, branchIn(file));
  if (course.empty())
    throw error("{}: has no frames in branch {}; leave --branch out", file.name(), branchIn(file));
  if (std::llround(from * frameRate) > course.back().last)
    throw usageError("--from is {} s, and branch {} ends at {:.3g} s; give an earlier time", from,
                     branchIn(file), double(course.back().last) / frameRate);
  const auto frameAt = [&](double time) {
    const double frame = time * frameRate;
    return frame < double(course.back().last) ? std::llround(frame) : course.back().last;
  };
  return partOf(course, frameAt(from), frameAt(to));
}

void addPartOptions(Command command, RecordedPart& part) {
  command.option("--from", part.from, "Where to begin, s").showDefault();
  command.option("--to", part.to, "Where to end, s; without it at the recording's end");
  command
      .option("--branch", part.branch,
              "Course of the operation, from its start; without it the one that was last")
      .notNegative();
}

}  // namespace resect

#include "cli/picture_writer.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/error.h"
#include "formats/png_file.h"
#include "formats/video.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operation_view.h"

namespace resect {

void parseSize(const std::string& text, int& width, int& height) {
  const char* end = text.data() + text.size();
  const auto [x, first] = std::from_chars(text.data(), end, width);
  if (first == std::errc() && x != end && *x == 'x') {
    const auto [rest, second] = std::from_chars(x + 1, end, height);
    if (second == std::errc() && rest == end && width >= 16 && width <= 8192 && height >= 16 &&
        height <= 8192)
      return;
  }
  throw usageError("--size is \"{}\"; give width x height in pixels, 16 to 8192 each, as 1280x720",
                   text);
}

NumberedOutputs framesIn(const std::string& folder) {
  return {"--frames", folder, "frame_", ".png"};
}

struct PictureWriter::State {
  State(const Scenario& scenario, Simulation& simulation, const PictureSettings& wanted, int width,
        int height)
      : settings(wanted),
        frameRate(scenario.frameRate),
        picture(width, height, wanted.quality),
        operation(scenario, simulation, double(width) / height) {
    operation.room().setShadowResolution(wanted.quality.shadowTexels);
    operation.room().showHands(wanted.hands);
    if (!settings.video.empty()) video.emplace(settings.video, width, height, settings.rate);
    if (!settings.folder.empty() && settings.overwrite)
      removeNumberedFiles(framesIn(settings.folder));
  }

  void draw() {
    const RgbImage image = operation.draw(picture);
    ++drawn;
    if (video) video->add(image);
    if (!settings.folder.empty())
      writePng(std::filesystem::path(settings.folder) / fmt::format("frame_{:04}.png", drawn),
               image);
  }

  PictureSettings settings;
  double frameRate;
  OffscreenView picture;
  OperationView operation;
  std::optional<VideoWriter> video;
  int drawn = 0;
  bool lastDrawn = true;
};

PictureWriter::PictureWriter(const Scenario& scenario, Simulation& simulation,
                             const PictureSettings& settings) {
  int width = 0, height = 0;
  parseSize(settings.size, width, height);
  state_ = std::make_unique<State>(scenario, simulation, settings, width, height);
  state_->draw();
}

PictureWriter::~PictureWriter() = default;

void PictureWriter::follow(const Simulation& simulation, const StepReport& step) {
  state_->operation.follow(simulation);
  state_->operation.followSmoke(step);
  // Picture k is due in the first frame that ends at k / rate or later.
  const double before = double(step.frame) / state_->frameRate,
               now = double(step.frame + 1) / state_->frameRate;
  const bool due = std::floor(now * state_->settings.rate + 1e-9) >
                   std::floor(before * state_->settings.rate + 1e-9);
  state_->lastDrawn = due;
  if (due) state_->draw();
}

std::vector<std::string> PictureWriter::finish() {
  if (!state_->lastDrawn) state_->draw();
  std::vector<std::string> files;
  if (!state_->settings.folder.empty())
    files.push_back(fmt::format("{}/frame_0001.png ... frame_{:04}.png", state_->settings.folder,
                                state_->drawn));
  if (state_->video) {
    state_->video->finish();
    files.push_back(state_->settings.video);
  }
  return files;
}

}  // namespace resect

#include "cli/debrief/key_pictures.h"

#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "formats/png_file.h"
#include "formats/video.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operation_view.h"
#include "io/whole_file.h"
#include "record/export/moments.h"

namespace resect {

namespace {

constexpr int kWidth = 640, kHeight = 400;

// The pictures of some frames, as a film in a folder of its own.
class Clip {
 public:
  // From a little before the frame to a little after it. rate: frames per second.
  Clip(std::int64_t frame, double rate, std::int64_t end) {
    constexpr double kBefore = 1.4, kAfter = 0.6, kPictures = 15;  // s, s, per second
    every_ = std::max<std::int64_t>(1, std::llround(rate / kPictures));
    first_ = std::max<std::int64_t>(1, frame - std::llround(kBefore * rate));
    last_ = std::min<std::int64_t>(end, frame + std::llround(kAfter * rate));
    std::string name = (std::filesystem::temp_directory_path() / "resect_clip_XXXXXX").string();
    if (!::mkdtemp(name.data())) return;
    folder_ = name;
    writer_.emplace(folder_ / "clip.mp4", kWidth, kHeight, rate / double(every_));
  }
  ~Clip() {
    writer_.reset();
    std::error_code ec;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ec);
  }
  Clip(const Clip&) = delete;
  Clip& operator=(const Clip&) = delete;

  std::int64_t last() const { return last_; }
  bool wants(std::int64_t frame) const {
    return writer_ && frame >= first_ && frame <= last_ && (frame - first_) % every_ == 0;
  }
  void add(const RgbImage& picture) { writer_->add(picture); }
  std::string bytes() {
    if (!writer_) return "";
    writer_->finish();
    return readWholeFile(folder_ / "clip.mp4");
  }

 private:
  std::int64_t first_ = 0, last_ = 0, every_ = 1;
  std::filesystem::path folder_;
  std::optional<VideoWriter> writer_;
};

}  // namespace

KeyMoments keyMoments(const std::filesystem::path& recording,
                      const std::vector<std::optional<double>>& times, const Progress& progress) {
  KeyMoments moments{std::vector<std::string>(times.size()), ""};
  Replay replay(recording);
  const Scenario& scenario = replay.setup().scenario;
  std::map<std::int64_t, std::string> byFrame;
  const auto frameOf = [&](double time) { return std::llround(time * scenario.frameRate); };
  for (const std::optional<double>& time : times)
    if (time && byFrame.size() < kMostKeyPictures) byFrame[frameOf(*time)];
  const std::vector<CourseSpan> course = courseOf(replay.file(), replay.file().moment().branch);
  if (byFrame.empty() || course.empty()) return moments;
  std::optional<Clip> clip;
  const auto first = std::ranges::find_if(times, [](const auto& time) { return time.has_value(); });
  if (haveFfmpeg()) clip.emplace(frameOf(**first), scenario.frameRate, course.back().last);
  const auto part = partOf(course, course.front().first,
                           std::max(byFrame.rbegin()->first, clip ? clip->last() : 0));

  OffscreenView picture(kWidth, kHeight);
  replay.goTo(part.front().branch, part.front().first);
  OperationView view(scenario, replay.simulation(), double(kWidth) / kHeight);
  const Simulation& now = replay.simulation();
  playMoments(
      replay, {part, 0}, false, [](const Simulation&) {}, progress,
      [&](const StepReport& step) {
        view.follow(now);
        view.followSmoke(step);
        const auto at = byFrame.find(now.frame());
        const bool moves = clip && clip->wants(now.frame());
        if (at == byFrame.end() && !moves) return;
        const RgbImage drawn = view.draw(picture);
        if (moves) clip->add(drawn);
        if (at != byFrame.end()) at->second = pngBytes(drawn);
      });
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i])
      if (const auto at = byFrame.find(frameOf(*times[i])); at != byFrame.end())
        moments.pictures[i] = std::exchange(at->second, "");
  if (clip) moments.clip = clip->bytes();
  return moments;
}

}  // namespace resect

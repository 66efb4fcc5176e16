#include "cli/debrief/key_pictures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "formats/png_file.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operation_view.h"
#include "record/export/moments.h"

namespace resect {

std::vector<std::string> keyPictures(const std::filesystem::path& recording,
                                     const std::vector<std::optional<double>>& times,
                                     const Progress& progress) {
  constexpr int kWidth = 640, kHeight = 400;
  std::vector<std::string> pictures(times.size());
  Replay replay(recording);
  const Scenario& scenario = replay.setup().scenario;
  std::map<std::int64_t, std::string> byFrame;
  const auto frameOf = [&](double time) { return std::llround(time * scenario.frameRate); };
  for (const std::optional<double>& time : times)
    if (time && byFrame.size() < kMostKeyPictures) byFrame[frameOf(*time)];
  const std::vector<CourseSpan> course = courseOf(replay.file(), replay.file().moment().branch);
  if (byFrame.empty() || course.empty()) return pictures;
  const auto part = partOf(course, course.front().first, byFrame.rbegin()->first);

  OffscreenView picture(kWidth, kHeight);
  replay.goTo(part.front().branch, part.front().first);
  OperationView view(scenario, replay.simulation(), double(kWidth) / kHeight);
  const Simulation& now = replay.simulation();
  playMoments(
      replay, {part, 0}, false, [](const Simulation&) {}, progress,
      [&](const StepReport&) {
        view.follow(now);
        if (const auto at = byFrame.find(now.frame()); at != byFrame.end())
          at->second = pngBytes(view.draw(picture));
      });
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i])
      if (const auto at = byFrame.find(frameOf(*times[i])); at != byFrame.end())
        pictures[i] = std::exchange(at->second, "");
  return pictures;
}

}  // namespace resect

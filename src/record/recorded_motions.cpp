#include "record/recorded_motions.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "record/course.h"
#include "record/file/frame_bytes.h"

namespace resect {
namespace {

// How far `key` is from the motion between two others, in tolerances.
double missed(const ToolKey& from, const ToolKey& to, const ToolKey& key,
              const MotionTolerance& tolerance) {
  const double share = (key.time - from.time) / (to.time - from.time);
  const Pose between = interpolate(from.pose, to.pose, share);
  const auto off = [&](double a, double b, double value) {
    return std::abs(a + share * (b - a) - value) / tolerance.share;
  };
  return std::max({(between.position - key.pose.position).norm() / tolerance.distance,
                   angleBetween(between.rotation, key.pose.rotation) / tolerance.angle,
                   off(from.squeeze, to.squeeze, key.squeeze),
                   off(from.pedal, to.pedal, key.pedal)});
}

// The inputs of all frames that lead to the moment, in order, with their times.
struct TimedInput {
  double time = 0;  // s
  FrameInput input;
};
std::vector<TimedInput> inputsOf(RecordingFile& file, const Moment& moment) {
  std::vector<TimedInput> inputs;
  for (const CourseSpan& span : courseTo(file, moment))
    for (std::int64_t frame = span.first + 1; frame <= span.last; ++frame) {
      const auto recorded = file.frame(span.branch, frame);
      if (!recorded) throw error("{}: lacks frame {}; take an earlier copy", file.name(), frame);
      const bool whole = recorded->whole || inputs.empty();
      FrameInput input =
          frameFromBytes(recorded->input, whole ? FrameInput() : inputs.back().input);
      input.edits.clear();
      inputs.push_back({recorded->time, std::move(input)});
    }
  return inputs;
}

}  // namespace

std::vector<ToolKey> thinned(const std::vector<ToolKey>& keys, const MotionTolerance& tolerance) {
  if (keys.size() < 3) return keys;
  std::vector<std::uint8_t> kept(keys.size(), 0);
  kept.front() = kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, keys.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = 1;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double one = missed(keys[first], keys[last], keys[i], tolerance); one > worst)
        worst = one, at = i;
    if (at == first) continue;
    kept[at] = 1;
    open.push_back({first, at});
    open.push_back({at, last});
  }
  std::vector<ToolKey> fewer;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (kept[i]) fewer.push_back(keys[i]);
  return fewer;
}

std::vector<std::vector<ToolKey>> recordedMotions(RecordingFile& file, const Moment& moment,
                                                  const MotionTolerance& tolerance) {
  const std::vector<TimedInput> inputs = inputsOf(file, moment);
  const std::size_t tools = inputs.empty() ? 0 : inputs.front().input.tools.size();
  std::vector<std::vector<ToolKey>> motions(file.setup().scenario.tools.size());
  for (std::size_t t = 0; t < std::min(tools, motions.size()); ++t) {
    std::vector<ToolKey> keys;
    std::size_t used = 0;  // keys up to the last frame in which the tool is in hand
    for (const TimedInput& one : inputs) {
      const ToolInput& tool = one.input.tools[t];
      if (keys.empty() && !tool.inHand) continue;
      keys.push_back({one.time, tool.pose, tool.squeeze, tool.pedal});
      if (tool.inHand) used = keys.size();
    }
    keys.resize(used);
    motions[t] = thinned(keys, tolerance);
  }
  return motions;
}

}  // namespace resect

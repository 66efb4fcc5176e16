#include "operation/live/live_operation.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/error.h"
#include "base/progress.h"
#include "base/stage_clock.h"
#include "base/stop.h"
#include "operation/live/squeeze_speed.h"

namespace resect {
namespace {

double restVolume(const Simulation& simulation) {
  double sum = 0;
  for (const OperatedOrgan& o : simulation.organs()) sum += o.organ.rest.volume();
  return sum;
}

}  // namespace

LiveOperation::LiveOperation(std::unique_ptr<Simulation> simulation, const std::vector<Pose>& rests,
                             double frameRate, OperationWatch watch)
    : simulation_(std::move(simulation)),
      watch_(std::move(watch)),
      frameRate_(frameRate),
      wholeVolume_(restVolume(*simulation_)),
      publishers_(simulation_->organs().size()) {
  require(frameRate >= 1 && frameRate <= 1000, "{} frames a second were asked for; give 1 to 1000",
          frameRate);
  require(rests.size() == simulation_->tools().size(),
          "there are {} places for {} tools; give one for each", rests.size(),
          simulation_->tools().size());
  simulation_->keepLook();
  input_.duration = 1 / frameRate_;
  for (const Pose& rest : rests) input_.tools.push_back({rest, false, 1});
  thread_ = std::thread([this] { work(); });
}

LiveOperation::~LiveOperation() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void LiveOperation::setTool(int tool, const ToolInput& input) {
  const std::lock_guard lock(mutex_);
  require(tool >= 0 && std::size_t(tool) < input_.tools.size(),
          "there is no tool {} among {}; number from 0", tool, input_.tools.size());
  input_.tools[std::size_t(tool)] = input;
}

void LiveOperation::setIso(float iso) {
  const std::lock_guard lock(mutex_);
  input_.iso = iso;
}

void LiveOperation::play(std::function<std::optional<FrameInput>()> motion) {
  const std::lock_guard lock(mutex_);
  motion_ = std::move(motion);
}

bool LiveOperation::playing() const {
  const std::lock_guard lock(mutex_);
  return bool(motion_);
}

void LiveOperation::setPaused(bool paused) {
  {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
  }
  wake_.notify_all();
}

void LiveOperation::undo() { ask(Jump::Undo); }
void LiveOperation::redo() { ask(Jump::Redo); }

void LiveOperation::endStroke() {
  const std::lock_guard lock(mutex_);
  strokeEnds_ = true;
}

void LiveOperation::ask(Jump jump) {
  const std::lock_guard lock(mutex_);
  jump_ = jump;
}

// In the thread: goes to another state; the tools stay where they are in it.
void LiveOperation::jump(Jump jump, FrameInput& input) {
  const bool undo = jump == Jump::Undo;
  const bool done = undo ? history_.undo(*simulation_) : history_.redo(*simulation_);
  if (done && watch_.jumped) watch_.jumped(undo, *simulation_);
  const std::lock_guard lock(mutex_);
  if (done) {
    for (std::size_t o = 0; o < publishers_.size(); ++o)
      publishers_[o].follow(presentSurface(*simulation_, o));
    for (std::size_t i = 0; i < input.tools.size(); ++i) {
      const ToolState& tool = simulation_->tools()[i];
      input.tools[i] = {tool.pose(), tool.inHand, tool.way.to.squeeze, 0};
    }
    input_.tools = input.tools;
    motion_ = {};
  }
  ++state_.jumps;
  state_.jumpedTools = input.tools;
}

bool LiveOperation::take(std::vector<SurfaceUpdate>& updates, LiveState& state) {
  const std::lock_guard lock(mutex_);
  if (!fresh_) return false;
  fresh_ = false;
  updates.clear();
  for (SurfacePublisher& publisher : publishers_) updates.push_back(publisher.take());
  state = state_;
  state_.faults.clear();
  return true;
}

SurfaceTracker::Compact LiveOperation::surface() {
  std::unique_lock lock(mutex_);
  ++readers_;
  newFrame_.wait(lock, [&] { return !stepping_; });
  SurfaceTracker::Compact surface = simulation_->surface();
  --readers_;
  lock.unlock();
  wake_.notify_all();
  return surface;
}

void LiveOperation::waitFor(std::int64_t frame) {
  std::unique_lock lock(mutex_);
  newFrame_.wait(lock, [&] { return state_.frame >= frame; });
}

// Waits until the next frame is due; returns nothing when the operation ends.
std::optional<LiveOperation::Frame> LiveOperation::nextFrame(
    std::chrono::steady_clock::time_point due) {
  std::unique_lock lock(mutex_);
  wake_.wait_until(lock, due, [&] { return ending_; });
  wake_.wait(lock, [&] { return ending_ || (!paused_ && readers_ == 0); });
  if (ending_) return std::nullopt;
  stepping_ = true;
  Frame frame{input_, {}, std::exchange(jump_, Jump::None), std::exchange(strokeEnds_, false)};
  input_.iso.reset();
  if (const auto next = motion_ ? motion_() : std::nullopt)
    frame.input.tools = frame.played = next->tools;
  else
    motion_ = {};
  return frame;
}

void LiveOperation::work() {
  using Clock = std::chrono::steady_clock;
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / frameRate_));
  LastSecond lastSecond(frameRate_);
  const StopBy stop(stop_);
  StepReport report;
  auto due = Clock::now();
  while (std::optional<Frame> frame = nextFrame(due)) {
    FrameInput& input = frame->input;
    if (frame->jump != Jump::None) {
      frame->played.clear();
      jump(frame->jump, input);
    } else if (frame->played.empty())  // moved by hand
      for (std::size_t i = 0; i < input.tools.size(); ++i)
        input.tools[i].squeeze = squeezeTowards(
            input.tools[i].squeeze, simulation_->tools()[i].way.to.squeeze, input.duration);
    StageClock clock;
    std::string refusal;
    try {
      if (frame->strokeEnds) history_.endStroke();
      history_.beforeStep(input, *simulation_);
      simulation_->step(input, report, &clock);
      history_.afterStep(input, report);
      if (watch_.stepped) watch_.stepped(input, report, *simulation_);
    } catch (const Cancelled&) {
      return;  // only the destructor stops a frame
    } catch (const Error& e) {
      refusal = e.what();
    }
    lastSecond.add(clock, steadySeconds());
    StepTimes times = lastSecond.times();
    {
      const std::lock_guard lock(mutex_);
      if (refusal.empty()) {
        for (std::size_t o = 0; o < publishers_.size(); ++o)
          publishers_[o].follow(presentSurface(*simulation_, o));
        noteStep(state_, *simulation_, report, wholeVolume_);
        state_.played = std::move(frame->played);
        state_.undoable = history_.undoable();
        state_.redoable = history_.redoable();
      } else {
        motion_ = {};
        state_.faults.push_back(refusal);
      }
      state_.times = std::move(times);
      fresh_ = true;
      stepping_ = false;
    }
    newFrame_.notify_all();
    due = std::max(due + period, Clock::now());
  }
}

}  // namespace resect

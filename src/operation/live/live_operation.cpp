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
                             double frameRate, OperationWatch watch,
                             std::optional<OperationHistory> history)
    : simulation_(std::move(simulation)),
      history_(history ? std::move(*history) : OperationHistory(*simulation_, frameRate)),
      lastSecond_(frameRate),
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
  if (history) {
    showing_ = true;
    input_.tools = presentTools();
    publishMoment(history_.now());
  }
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

void LiveOperation::play(Motion motion) {
  const std::lock_guard lock(mutex_);
  if (!motion) {  // also one that is to come
    if (request_) request_->motion = {};
    motionComes_ = false;
  }
  motion_ = std::move(motion);
}

std::int64_t LiveOperation::playFromStart(Motion motion) {
  return ask({Request::Kind::Show, {0, 0}, std::move(motion)});
}

bool LiveOperation::playing() const {
  const std::lock_guard lock(mutex_);
  return motion_ || motionComes_ || (request_ && request_->motion);
}

void LiveOperation::setPaused(bool paused) {
  {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
  }
  wake_.notify_all();
}

std::int64_t LiveOperation::undo() { return ask({Request::Kind::Undo, {}, {}}); }
std::int64_t LiveOperation::redo() { return ask({Request::Kind::Redo, {}, {}}); }
std::int64_t LiveOperation::show(Moment moment) { return ask({Request::Kind::Show, moment, {}}); }

std::int64_t LiveOperation::ask(Request request) {
  std::int64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    request.number = number = ++asked_;
    request_ = std::move(request);
    if (replaceable_) stop_ = true;
  }
  wake_.notify_all();
  return number;
}

void LiveOperation::setPlayback(double speed) {
  require(speed >= 0 && speed <= 100, "a playback speed of {} was asked for; give 0 to 100", speed);
  {
    const std::lock_guard lock(mutex_);
    playback_ = speed;
    state_.playback = showing_ ? speed : 0;
    fresh_ = true;
  }
  wake_.notify_all();
}

void LiveOperation::goOn() {
  {
    const std::lock_guard lock(mutex_);
    if (request_ || state_.answered != asked_) return;
    showing_ = false;
    playback_ = 0;
  }
  wake_.notify_all();
}

void LiveOperation::endStroke() {
  const std::lock_guard lock(mutex_);
  input_.strokeEnds = true;
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

void LiveOperation::waitForAnswer() {
  std::unique_lock lock(mutex_);
  newFrame_.wait(lock, [&] { return state_.answered == asked_ && !stepping_; });
}

// Waits until there is something to do, and a frame is due if it is a frame; returns nothing when
// the operation ends.
std::optional<LiveOperation::Task> LiveOperation::nextTask(
    std::chrono::steady_clock::time_point due) {
  std::unique_lock lock(mutex_);
  wake_.wait_until(lock, due, [&] { return ending_ || (request_ && readers_ == 0); });
  wake_.wait(lock, [&] {
    const bool frames = !paused_ && (!showing_ || playback_ > 0);
    return ending_ || (readers_ == 0 && (request_ || frames));
  });
  if (ending_) return std::nullopt;
  stepping_ = true;
  Task task;
  if (request_) {
    task.request = std::exchange(request_, std::nullopt);
    stop_ = ending_;
    motionComes_ = bool(task.request->motion);
    return task;
  }
  if (showing_) {
    task.playback = playback_;
    return task;
  }
  task.input = input_;
  input_.iso.reset();
  input_.strokeEnds = false;
  if (const auto next = motion_ ? motion_() : std::nullopt) {
    task.input.tools = next->tools;
    task.byMotion = true;
  } else {
    motion_ = {};
  }
  return task;
}

// In the thread, all below.

void LiveOperation::work() {
  using Clock = std::chrono::steady_clock;
  const StopBy stop(stop_);
  auto due = Clock::now();
  while (std::optional<Task> task = nextTask(due)) {
    const double speed = task->playback > 0 ? task->playback : 1;
    try {
      if (task->request)
        answer(std::move(*task->request));
      else if (task->playback > 0)
        playBack();
      else
        operate(std::move(*task));
    } catch (const Cancelled&) {
      // By the destructor, or by a newer request, which nextTask() will find.
    } catch (const Error& e) {  // a recorded frame that cannot be played
      const std::lock_guard lock(mutex_);
      playback_ = state_.playback = 0;
      state_.faults.push_back(e.what());
    }
    {
      const std::lock_guard lock(mutex_);
      stepping_ = false;
    }
    newFrame_.notify_all();
    const auto period = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(1 / (frameRate_ * speed)));
    due = std::max(due + period, Clock::now());
  }
}

void LiveOperation::operate(Task task) {
  if (!task.byMotion)
    for (std::size_t i = 0; i < task.input.tools.size(); ++i) {
      ToolInput& tool = task.input.tools[i];
      tool.squeeze =
          squeezeTowards(tool.squeeze, simulation_->tools()[i].way.to.squeeze, task.input.duration);
    }
  StageClock clock;
  std::string refusal;
  std::optional<Branch> begun;
  try {
    begun = history_.beforeStep(task.input, *simulation_);
    if (begun && watch_.began) watch_.began(*begun, *simulation_);
    simulation_->step(task.input, report_, &clock);
    const auto events = history_.afterStep(task.input, report_, *simulation_);
    if (watch_.stepped) watch_.stepped(history_.now(), task.input, report_, events, *simulation_);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& e) {
    refusal = e.what();
  }
  lastSecond_.add(clock, steadySeconds());
  StepTimes times = lastSecond_.times();
  const std::lock_guard lock(mutex_);
  if (refusal.empty()) {
    for (std::size_t o = 0; o < publishers_.size(); ++o)
      publishers_[o].follow(presentSurface(*simulation_, o));
    noteStep(state_, *simulation_, report_, wholeVolume_, history_.peaks());
    if (task.byMotion)
      state_.played = std::move(task.input.tools);
    else
      state_.played.clear();
    state_.showing = false;
    if (begun || std::abs(simulation_->frame() - timelineFrame_) > 15) timelineFrame_ = -1;
    noteHistory();
  } else {
    motion_ = {};
    state_.faults.push_back(refusal);
  }
  state_.times = std::move(times);
  fresh_ = true;
}

// Goes to the moment that is asked for and shows it.
void LiveOperation::answer(Request request) {
  const Moment before = history_.now();
  std::optional<Moment> moment = request.moment;
  if (request.kind == Request::Kind::Undo) moment = history_.undoMoment();
  if (request.kind == Request::Kind::Redo) moment = history_.redoMoment();
  std::string refusal;
  if (moment) {
    try {
      history_.goTo(*moment, *simulation_, [&] {
        publishMoment({moment->branch, simulation_->frame()});
        const std::lock_guard lock(mutex_);
        replaceable_ = true;
      });
    } catch (const Cancelled&) {
      const std::lock_guard lock(mutex_);
      replaceable_ = motionComes_ = false;
      throw;
    } catch (const Error& e) {
      refusal = e.what();
    }
    if (refusal.empty()) {
      if (request.kind == Request::Kind::Undo) history_.undone(before);
      if (request.kind == Request::Kind::Redo) history_.redone();
    }
  }
  const std::lock_guard lock(mutex_);
  replaceable_ = false;
  stop_ = ending_;
  state_.answered = request.number;
  if (!refusal.empty()) state_.faults.push_back(refusal);
  if (moment && refusal.empty()) {
    noteMoment(state_, *simulation_, wholeVolume_, history_.peaks());
    input_.tools = state_.played = presentTools();
    const bool plays = motionComes_;
    showing_ = state_.showing = !plays;
    playback_ = state_.playback = 0;
    motion_ = plays ? std::move(request.motion) : Motion();
    timelineFrame_ = -1;
    noteHistory();
  }
  motionComes_ = false;
  fresh_ = true;
}

// Plays the next recorded frame; stands at the end of the branch.
void LiveOperation::playBack() {
  const bool played = history_.playNext(*simulation_, report_);
  const std::lock_guard lock(mutex_);
  if (!played) playback_ = state_.playback = 0;
  for (std::size_t o = 0; played && o < publishers_.size(); ++o)
    publishers_[o].follow(presentSurface(*simulation_, o));
  if (played) noteStep(state_, *simulation_, report_, wholeVolume_, history_.peaks());
  state_.played = presentTools();
  if (showing_) input_.tools = state_.played;
  noteHistory();
  fresh_ = true;
}

// On the way to a moment: what is there so far is published.
void LiveOperation::publishMoment(Moment moment) {
  const std::lock_guard lock(mutex_);
  for (std::size_t o = 0; o < publishers_.size(); ++o)
    publishers_[o].follow(presentSurface(*simulation_, o));
  noteMoment(state_, *simulation_, wholeVolume_, history_.peaks());
  state_.played = presentTools();
  state_.showing = true;
  state_.moment = moment;
  if (!state_.timeline) noteHistory();
  fresh_ = true;
}

// With mutex_ locked.
void LiveOperation::noteHistory() {
  state_.moment = history_.now();
  state_.undoable = history_.undoable();
  state_.redoable = history_.redoable();
  state_.historyBytes = history_.bytes();
  if (timelineFrame_ >= 0 && state_.timeline) return;
  state_.timeline = std::make_shared<const Timeline>(timelineOf(history_));
  timelineFrame_ = simulation_->frame();
}

std::vector<ToolInput> LiveOperation::presentTools() const {
  std::vector<ToolInput> tools;
  for (const ToolState& tool : simulation_->tools())
    tools.push_back({tool.pose(), tool.inHand, tool.way.to.squeeze, 0});
  return tools;
}

}  // namespace resect

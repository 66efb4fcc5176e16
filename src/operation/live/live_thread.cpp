// What the thread of a live operation does.
#include <chrono>
#include <cstdlib>
#include <utility>

#include "base/error.h"
#include "base/progress.h"
#include "base/stage_clock.h"
#include "base/stop.h"
#include "operation/live/hand_speed.h"
#include "operation/live/live_operation.h"

namespace resect {

// Waits until there is something to do, and a frame is due if it is a frame; returns nothing when
// the operation ends.
std::optional<LiveOperation::Task> LiveOperation::nextTask(
    std::chrono::steady_clock::time_point due) {
  std::unique_lock lock(mutex_);
  wake_.wait_until(lock, due, [&] { return ending_ || (!requests_.empty() && readers_ == 0); });
  wake_.wait(lock, [&] {
    const bool frames = !paused_ && (!showing_ || playback_ > 0);
    return ending_ || (readers_ == 0 && (!requests_.empty() || frames || !names_.empty()));
  });
  if (ending_) return std::nullopt;
  stepping_ = true;
  Task task;
  task.operated = !showing_;
  if (mostBytes_) history_.setMostBytes(*std::exchange(mostBytes_, std::nullopt));
  if (!names_.empty()) {
    task.names = std::exchange(names_, {});
    return task;
  }
  if (!requests_.empty()) {
    task.request = std::move(requests_.front());
    requests_.pop_front();
    stop_ = ending_;
    motionComes_ = bool(task.request->motion);
    return task;
  }
  if (showing_) {
    task.playback = playback_;
    task.towards = towards_;
    return task;
  }
  task.input = input_;
  task.motions = motions_;
  task.sight = sight_;
  input_.iso.reset();
  input_.breathes.reset();
  input_.strokeEnds = false;
  if (const auto next = motion_ ? motion_() : std::nullopt) {
    task.input.tools = next->tools;
    task.byMotion = true;
  } else {
    motion_ = {};
  }
  return task;
}

void LiveOperation::work() {
  using Clock = std::chrono::steady_clock;
  auto stop = std::make_optional<StopBy>(stop_);
  auto due = Clock::now();
  bool whole = true;  // no step was left in the middle
  while (std::optional<Task> task = nextTask(due)) {
    const double speed = task->playback > 0 ? task->playback : 1;
    try {
      whole = true;
      if (!task->names.empty()) {
        nameBranches(task->names);
      } else if (task->request) {
        if (task->operated) stand();
        answer(std::move(*task->request));
      } else if (task->playback > 0)
        playBack(task->towards);
      else
        operate(std::move(*task));
    } catch (const Cancelled&) {
      // By the destructor, or by a newer request, which nextTask() will find.
      whole = false;
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
  stop.reset();
  {
    const std::lock_guard lock(mutex_);
    whole = whole && !showing_;
  }
  if (whole) stand();
}

// Operating pauses here: what is known of the branch is brought up to date.
void LiveOperation::stand() {
  if (history_.broken() || !history_.atEnd()) return;
  if (ledger_)
    if (const Ledger* ledger = ledger_->last(*simulation_)) {
      keepLedger(ledger);
      history_.note(*ledger);
    }
  if (watch_.stood) watch_.stood(history_.now(), *simulation_);
}

void LiveOperation::operate(Task task) {
  if (!task.byMotion)
    for (std::size_t i = 0; i < task.input.tools.size(); ++i) {
      ToolInput& tool = task.input.tools[i];
      const ToolState& now = simulation_->tools()[i];
      tool.squeeze = squeezeTowards(tool.squeeze, now.way.to.squeeze, task.input.duration);
      const auto& motion = task.motions[i];
      const std::optional<Pose> before =
          std::exchange(pressedFrom_[i], motion ? std::optional(motion->from) : std::nullopt);
      if (!motion) continue;
      // Pressed anew, as after an undo: the tool is lifted for a frame, so that it does not work on
      // its way from the place where it was.
      if (now.inHand && !(before && before->position == motion->from.position)) {
        tool.inHand = false;
        tool.pose = motion->from;
        continue;
      }
      const Vec3 wanted = tool.pose.position;
      tool.pose = now.inHand
                      ? poseTowards(tool.pose, now.pose(), task.input.duration, motion->fastest)
                      : motion->from;
      if ((tool.pose.position - wanted).norm() > kArrived)
        tool.squeeze = std::min(tool.squeeze, std::max(now.way.to.squeeze, kOpenOnTheWay));
    }
  StageClock clock;
  std::string refusal;
  std::optional<Branch> begun;
  try {
    history_.mend(*simulation_);
    begun = history_.beforeStep(task.input, *simulation_);
    if (begun && ledger_) history_.note(ledger_->ledger());
    if (begun && watch_.began) watch_.began(*begun, *simulation_);
    simulation_->step(task.input, report_, &clock);
    std::vector<OperationEvent> events = history_.afterStep(task.input, report_, *simulation_);
    if (begun) sightSaid_.clear();
    for (OperationEvent& event : sightEvents(task.sight, *simulation_, sightSaid_)) {
      event.branch = history_.now().branch;
      events.push_back(std::move(event));
    }
    if (watch_.stepped) watch_.stepped(history_.now(), task.input, report_, events, *simulation_);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& e) {
    refusal = e.what();
  }
  lastSecond_.add(clock, steadySeconds());
  StepTimes times = lastSecond_.times();
  if (ledger_ && refusal.empty())
    if (const Ledger* ledger = ledger_->after(report_, *simulation_)) {
      keepLedger(ledger);
      history_.note(*ledger);
    }
  const std::lock_guard lock(mutex_);
  if (refusal.empty()) {
    for (std::size_t o = 0; o < publishers_.size(); ++o)
      publishers_[o].follow(presentSurface(*simulation_, o));
    noteStep(state_, *simulation_, report_, wholeVolume_, history_.peaks());
    state_.adnexa = adnexa_.follow(*simulation_);
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
  // A request before may have been stopped on its way.
  if (!moment && history_.broken()) moment = before;
  std::string refusal;
  if (moment) {
    try {
      history_.goTo(*moment, *simulation_, [&] {
        publishMoment({moment->branch, simulation_->frame()});
        const std::lock_guard lock(mutex_);
        replaceable_ = request.kind == Request::Kind::Show;
      });
    } catch (const Cancelled&) {
      const std::lock_guard lock(mutex_);
      replaceable_ = motionComes_ = false;
      throw;
    } catch (const Error& e) {
      refusal = e.what();
    }
    {
      const std::lock_guard lock(mutex_);  // it is reached: nothing stops it any more
      replaceable_ = false;
      stop_ = ending_;
    }
    lastSecond_ = LastSecond(frameRate_);
    if (ledger_ && refusal.empty()) keepLedger(&ledger_->anew(*simulation_));
    if (refusal.empty()) {
      if (request.kind == Request::Kind::Undo && !(*moment == before)) history_.undone(before);
      if (request.kind == Request::Kind::Redo && !(*moment == before)) history_.redone();
    }
  }
  const std::lock_guard lock(mutex_);
  state_.answered = request.number;
  if (!refusal.empty()) state_.faults.push_back(refusal);
  if (moment && refusal.empty()) {
    noteMoment(state_, *simulation_, wholeVolume_, history_.peaks());
    state_.adnexa = adnexa_.follow(*simulation_);
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

void LiveOperation::nameBranches(const std::vector<std::pair<std::int64_t, std::string>>& names) {
  for (const auto& [branch, name] : names) {
    history_.rename(branch, name);
    if (watch_.renamed) watch_.renamed(history_.courses()[std::size_t(branch)].branch);
  }
  const std::lock_guard lock(mutex_);
  timelineFrame_ = -1;
  noteHistory();
  fresh_ = true;
}

// Plays the next recorded frame; stands at the end of the branch.
void LiveOperation::playBack(std::int64_t towards) {
  history_.mend(*simulation_);
  const bool played = history_.playNext(*simulation_, report_, towards);
  if (ledger_ && played) keepLedger(ledger_->after(report_, *simulation_));
  const std::lock_guard lock(mutex_);
  if (!played) playback_ = state_.playback = 0;
  for (std::size_t o = 0; played && o < publishers_.size(); ++o)
    publishers_[o].follow(presentSurface(*simulation_, o));
  if (played) noteStep(state_, *simulation_, report_, wholeVolume_, history_.peaks());
  state_.adnexa = adnexa_.follow(*simulation_);
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
  state_.adnexa = adnexa_.follow(*simulation_);
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

void LiveOperation::keepLedger(const Ledger* ledger) {
  if (!ledger) return;
  auto kept = std::make_shared<const Ledger>(*ledger);
  const std::lock_guard lock(mutex_);
  state_.ledger = std::move(kept);
}

std::vector<ToolInput> LiveOperation::presentTools() const {
  std::vector<ToolInput> tools;
  if (simulation_->frame() == 0) {  // the tools have not been placed yet
    for (const Pose& rest : rests_) tools.push_back({rest, false, 1});
    return tools;
  }
  for (const ToolState& tool : simulation_->tools())
    tools.push_back({tool.pose(), tool.inHand, tool.way.to.squeeze, 0});
  return tools;
}

}  // namespace resect

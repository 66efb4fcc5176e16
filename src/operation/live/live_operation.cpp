#include "operation/live/live_operation.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

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
                             std::optional<OperationHistory> history,
                             std::optional<LedgerWatch> ledger, bool paused)
    : simulation_(std::move(simulation)),
      history_(history ? std::move(*history) : OperationHistory(*simulation_, frameRate)),
      ledger_(std::move(ledger)),
      rests_(rests),
      lastSecond_(frameRate),
      watch_(std::move(watch)),
      frameRate_(frameRate),
      wholeVolume_(restVolume(*simulation_)),
      motions_(rests.size()),
      pressedFrom_(rests.size()),
      paused_(paused),
      publishers_(simulation_->organs().size()) {
  require(frameRate >= 1 && frameRate <= 1000, "{} frames a second were asked for; give 1 to 1000",
          frameRate);
  require(rests.size() == simulation_->tools().size(),
          "there are {} places for {} tools; give one for each", rests.size(),
          simulation_->tools().size());
  simulation_->keepLook();
  input_.duration = 1 / frameRate_;
  for (const Pose& rest : rests) input_.tools.push_back({rest, false, 1});
  if (ledger_) keepLedger(&ledger_->anew(*simulation_));
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

void LiveOperation::setTool(int tool, const ToolInput& input, std::optional<HandMotion> motion) {
  const std::lock_guard lock(mutex_);
  require(tool >= 0 && std::size_t(tool) < input_.tools.size(),
          "there is no tool {} among {}; number from 0", tool, input_.tools.size());
  input_.tools[std::size_t(tool)] = input;
  motions_[std::size_t(tool)] = std::move(motion);
}

void LiveOperation::setIso(float iso) {
  const std::lock_guard lock(mutex_);
  input_.iso = iso;
}

void LiveOperation::setBreathing(bool on) {
  const std::lock_guard lock(mutex_);
  input_.breathes = on;
}

void LiveOperation::setSight(std::vector<Sight> sight) {
  const std::lock_guard lock(mutex_);
  sight_ = std::move(sight);
}

void LiveOperation::play(Motion motion) {
  const std::lock_guard lock(mutex_);
  if (!motion) {  // also one that is to come
    for (Request& request : requests_) request.motion = {};
    motionComes_ = false;
  }
  motion_ = std::move(motion);
}

std::int64_t LiveOperation::playFromStart(Motion motion) {
  return ask({Request::Kind::Show, {0, 0}, std::move(motion)});
}

bool LiveOperation::playing() const {
  const std::lock_guard lock(mutex_);
  return motion_ || motionComes_ ||
         std::ranges::any_of(requests_, [](const Request& r) { return bool(r.motion); });
}

void LiveOperation::setPaused(bool paused) {
  {
    const std::lock_guard lock(mutex_);
    if (paused_ == paused) return;
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
    if (request.kind == Request::Kind::Show) {
      std::erase_if(requests_, [](const Request& r) { return r.kind == Request::Kind::Show; });
      if (replaceable_) stop_ = true;
    }
    requests_.push_back(std::move(request));
  }
  wake_.notify_all();
  return number;
}

void LiveOperation::setPlayback(double speed, std::int64_t branch) {
  require(speed >= 0 && speed <= 100, "a playback speed of {} was asked for; give 0 to 100", speed);
  {
    const std::lock_guard lock(mutex_);
    playback_ = speed;
    towards_ = branch;
    state_.playback = showing_ ? speed : 0;
    fresh_ = true;
  }
  wake_.notify_all();
}

void LiveOperation::goOn() {
  {
    const std::lock_guard lock(mutex_);
    if (state_.answered != asked_) return;
    showing_ = false;
    playback_ = 0;
  }
  wake_.notify_all();
}

void LiveOperation::endStroke() {
  const std::lock_guard lock(mutex_);
  input_.strokeEnds = true;
}

void LiveOperation::nameBranch(std::int64_t branch, const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    names_.emplace_back(branch, name);
  }
  wake_.notify_all();
}

void LiveOperation::setHistoryMemory(std::size_t most) {
  const std::lock_guard lock(mutex_);
  mostBytes_ = most;
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

void LiveOperation::look(const std::function<void(const Simulation&)>& read) {
  std::unique_lock lock(mutex_);
  ++readers_;
  newFrame_.wait(lock, [&] { return !stepping_; });
  read(*simulation_);
  --readers_;
  lock.unlock();
  wake_.notify_all();
}

SurfaceTracker::Compact LiveOperation::surface() {
  SurfaceTracker::Compact surface;
  look([&](const Simulation& simulation) { surface = simulation.surface(); });
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

}  // namespace resect

// What moves an operating session's tools besides the hand: motions that play, and moments of the
// history.
#include <algorithm>
#include <cmath>
#include <utility>

#include "inventor/hand/operating_session.h"

namespace resect {

void OperatingSession::play(double until) {
  following_ = true;
  tools_.hold(-1, ToolHandling::Hold::None);
  tools_.setLeft(std::vector<std::uint8_t>(toolModels_.size()));
  following_ = false;
  const std::int64_t all = frameCount(scenario_);
  if (played_ >= all) played_ = 0;
  playUntil_ = std::min<std::int64_t>(all, std::llround(until * scenario_.frameRate));
  playing_ = true, playedOut_ = false;
  auto motion = [scenario = scenario_, frame = played_, end = playUntil_]() mutable {
    return frame < end ? std::optional(frameInput(scenario, frame++)) : std::nullopt;
  };
  if (played_ == 0)
    asked_ = operation_.playFromStart(std::move(motion));
  else
    operation_.play(std::move(motion));
}

void OperatingSession::followMotion() {
  std::vector<ToolInput> inputs = state_.played;
  if (inputs.empty() && operation_.playing()) return;
  const bool over = inputs.empty();
  if (over) {
    // The last frames may not have been seen here.
    playing_ = false;
    played_ = playUntil_;
    playedOut_ = played_ == frameCount(scenario_);
    if (played_ > 0) inputs = frameInput(scenario_, played_ - 1).tools;
  }
  // Guided tools in hand are left at work, so that a hook keeps what it holds as the motion ends.
  std::vector<std::uint8_t> left(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    left[i] = tools_.usual() == ToolHandling::Hold::Guided && inputs[i].inHand;
    const bool rests = over && !left[i] && played_ == frameCount(scenario_);
    room().setToolPose(int(i), rests ? scenario_.tools[i].rest : inputs[i].pose);
  }
  if (!inputs.empty()) tools_.setLeft(left);
  toolsChanged();
}

// A guided tool that works is where the operation has brought it.
void OperatingSession::followHand() {
  const int held = tools_.held();
  if (!tools_.pressing() || state_.showing || std::size_t(held) >= state_.inHand.size() ||
      !state_.inHand[std::size_t(held)])
    return;
  room().setToolPose(held, state_.poses[std::size_t(held)]);
  toolsChanged();
}

void OperatingSession::undo() {
  leave();
  asked_ = operation_.undo();
}

void OperatingSession::redo() {
  leave();
  asked_ = operation_.redo();
}

void OperatingSession::show(Moment moment) {
  leave();
  asked_ = operation_.show(moment);
}

// Another moment will be shown: nothing plays or is dragged any more.
void OperatingSession::leave() {
  stopPlaying();
  played_ = 0, playedOut_ = false;
  tools_.interrupt();
  goingOn_ = false;
}

// Puts the tools where they are in the moment that is shown.
void OperatingSession::followMoment() {
  following_ = true;
  const bool guided = tools_.usual() == ToolHandling::Hold::Guided;
  // The hand keeps the guided tool that it has, unless that tool stood still in that moment and
  // held tissue: then it had been left at work. So are all other tools that worked, but an empty
  // hand takes the one that moved.
  constexpr double kHolds = 0.05;  // N
  int inHand = guided ? tools_.held() : -1;
  std::vector<std::uint8_t> left(state_.played.size());
  for (std::size_t i = 0; i < state_.played.size(); ++i) {
    room().setToolPose(int(i), state_.played[i].pose);
    if (!state_.played[i].inHand) continue;
    const bool kept = tools_.held() == int(i) && state_.forces[i] < kHolds;
    const bool moves = state_.moved[i] && (tools_.held() < 0 || tools_.held() == int(i));
    left[i] = guided && !kept && !moves;
    if (!left[i]) inHand = int(i);
  }
  if (inHand >= 0 && left[std::size_t(inHand)]) inHand = -1;
  if (inHand != tools_.held()) {
    tools_.hold(inHand, tools_.usual());
    if (inHand >= 0) room().setToolPose(inHand, state_.played[std::size_t(inHand)].pose);
  }
  if (guided) tools_.setLeft(left);
  iso_.setValue(state_.iso);
  toolsChanged();
  following_ = false;
}

void OperatingSession::stopPlaying() {
  if (!playing_) return;
  operation_.play({});
  playing_ = false;
  played_ = 0;
}

}  // namespace resect

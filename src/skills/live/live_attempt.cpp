#include "skills/live/live_attempt.h"

#include <algorithm>
#include <cmath>

#include "operation/live/sight.h"
#include "skills/attempt/unseen.h"
#include "skills/live/next_step.h"

namespace resect {
namespace {

Attempt begunAttempt(const Scenario& scenario) {
  Attempt attempt;
  attempt.title = scenario.title;
  attempt.scenario = scenario.name;
  attempt.task = scenario.task;
  return attempt;
}

}  // namespace

LiveAttempt::LiveAttempt(const Scenario& scenario, const Simulation& simulation)
    : attempt_(begunAttempt(scenario)),
      reader_(attempt_, scenario, simulation),
      organ_(goalOrgan(scenario.task->goal, scenario)),
      every_(std::max<std::int64_t>(1, std::llround(scenario.frameRate / 10))) {
  const Organ& organ = simulation.organs()[organ_].organ;
  if (const int label = labelNamed(organ, scenario.task->goal.structure); label > 0)
    for (std::int64_t cell = 0; cell < organ.rest.lattice.cellCount(); ++cell)
      if (organ.rest.inside[std::size_t(cell)] && organ.rest.labelOf(cell) == label)
        structure_.push_back(cell);
}

OperationWatch LiveAttempt::watch(OperationWatch next) {
  OperationWatch both = next;
  both.began = [self = shared_from_this(), next](const Branch& branch,
                                                 const Simulation& simulation) {
    if (next.began) next.began(branch, simulation);
    self->began(branch);
  };
  both.stepped = [self = shared_from_this(), next](
                     Moment moment, const FrameInput& input, const StepReport& report,
                     std::span<const OperationEvent> events, const Simulation& simulation) {
    if (next.stepped) next.stepped(moment, input, report, events, simulation);
    self->stepped(moment, report, events, simulation);
  };
  return both;
}

AttemptProgress LiveAttempt::progress() const {
  const std::scoped_lock lock(mutex_);
  return progress_;
}

void LiveAttempt::began(const Branch& branch) {
  if (branch.parent < 0) return;
  lost_ = lost_ || branch.parent != branch_;
  branch_ = branch.number;
  reader_.rewind(std::size_t(branch.from));
}

void LiveAttempt::stepped(Moment moment, const StepReport& report,
                          std::span<const OperationEvent> events, const Simulation& simulation) {
  lost_ = lost_ || moment.branch != branch_;
  if (lost_ || ended_) return;
  reader_.add(simulation, report);
  for (const OperationEvent& event : events)
    if (isSight(event) || event.kind == "put_back") events_.push_back(event);
  if (std::ranges::any_of(attempt_.instruments,
                          [](const auto& one) { return one.moments.back().inHand; }))
    worked_ = simulation.time();
  if (simulation.frame() % every_ == 0) publish(simulation);
}

std::optional<Attempt> LiveAttempt::end(std::int64_t frames, const Simulation& simulation) {
  if (lost_ || ended_ || attempt_.undos > 0) return {};
  ended_ = true;
  reader_.endAt(std::size_t(std::max<std::int64_t>(0, frames)), simulation);
  addUnseen(events_, 0, frames, attempt_);
  return attempt_;
}

void LiveAttempt::publish(const Simulation& simulation) {
  reader_.finish(simulation);
  const GoalResult goal = goalResult(attempt_);
  AttemptProgress now;
  now.time = simulation.time();
  now.reached = goal.reached;
  if (!goal.reached) reachedSince_.reset();
  if (goal.reached && !reachedSince_) reachedSince_ = now.time;
  now.since = reachedSince_.value_or(0);
  now.next = nextStep(attempt_, goal);
  const auto bled = std::ranges::find_if(attempt_.bled, [](double b) { return b > 0; });
  if (bled != attempt_.bled.end())
    now.bleeding =
        valueOf(goal.measures, "bleeding_s")
            .value_or(now.time - attempt_.time[std::size_t(bled - attempt_.bled.begin())]);
  now.rested = simulation.time() - worked_;
  now.target = nextTarget(goal);
  for (const TissuePoint& point : reader_.goal()->present()) {
    now.places.push_back(point.rest);
    now.normals.push_back(point.normal);
  }
  const OperatedOrgan& organ = simulation.organs()[organ_];
  const Lattice& lattice = organ.organ.rest.lattice;
  std::vector<Vec3> cells;
  for (const std::int64_t cell : structure_)
    if (organ.tissue->solid(cell))
      cells.push_back(lattice.centre(lattice.cell(cell)) + organ.tissue->displacement(cell));
  if (!cells.empty()) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& cell : cells) middle += cell / double(cells.size());
    for (const Vec3& cell : cells)
      now.structureRadius = std::max(now.structureRadius, (cell - middle).norm());
    now.structure = middle;
  }
  const std::scoped_lock lock(mutex_);
  progress_ = std::move(now);
}

}  // namespace resect

#include "skills/attempt/attempt_reader.h"

#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "operation/live/operation_events.h"

namespace resect {
namespace {

// Whether an instrument lies where it belongs while nobody has it. The pose of one that a hand
// carries over the organ without working is recorded like any other.
bool lies(const Pose& pose, const Pose& rest) {
  return (pose.position - rest.position).norm() < 1e-4 &&
         angleBetween(pose.rotation, rest.rotation) < 1e-2;
}

}  // namespace

AttemptReader::AttemptReader(Attempt& attempt, const Scenario& scenario,
                             const Simulation& simulation)
    : attempt_(attempt),
      books_(scenario, simulation),
      second_(std::max<std::int64_t>(1, std::llround(scenario.frameRate))) {
  attempt_.interval = 1 / scenario.frameRate;
  attempt_.bleeds = simulation.blood().any();
  attempt_.tissueMoves = simulation.moves();
  for (std::size_t t = 0; t < scenario.tools.size(); ++t) {
    const ToolModel& model = simulation.tools()[t].tool->model;
    attempt_.instruments.push_back(
        {model.name, modelOf(scenario.tools[t]), model.axis.normalized(), {}});
    rests_.push_back(scenario.tools[t].rest);
  }
  if (attempt_.task) goal_.emplace(attempt_.task->goal, scenario, simulation);
  if (attempt_.task) targetOrgan_ = goalOrgan(attempt_.task->goal, scenario);
  if (attempt_.task && attempt_.task->goal.kind == TaskGoal::Kind::Resect) {
    targetLabel_ =
        labelNamed(simulation.organs()[targetOrgan_].organ, attempt_.task->goal.structure);
  }
  takeLedger(simulation);
  if (attempt_.bleeds) vessels_.begin(simulation, attempt_);
}

void AttemptReader::add(const Simulation& simulation, const StepReport& report) {
  attempt_.time.push_back(simulation.time());
  for (std::size_t t = 0; t < attempt_.instruments.size(); ++t)
    attempt_.instruments[t].moments.push_back(momentOf(simulation, report, t));
  if (attempt_.bleeds) attempt_.bled.push_back(toCubicMetres(report.blood.ledger.bled));
  attempt_.torn += report.torn;
  vessels_.add(simulation, report, attempt_);
  if (goal_) goal_->add(simulation, attempt_);
  if (simulation.frame() % second_ == 0) takeLedger(simulation);
}

void AttemptReader::finish(const Simulation& simulation) {
  if (attempt_.tissue.back().time != simulation.time()) takeLedger(simulation);
  vessels_.finish(simulation, attempt_);
}

void AttemptReader::measureMargins(const Simulation& simulation) {
  if (targetLabel_ == 0 || !attempt_.margin) return;
  const Organ& organ = simulation.organs()[targetOrgan_].organ;
  const Lattice& lattice = organ.rest.lattice;
  std::vector<Vec3> cells;
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell)
    if (organ.rest.inside[std::size_t(cell)] && organ.rest.labelOf(cell) == targetLabel_)
      cells.push_back(lattice.centre(lattice.cell(cell)));
  Vec3 middle = Vec3::Zero();
  for (const Vec3& cell : cells) middle += cell / double(cells.size());
  attempt_.targetMiddle = middle;
  for (const Vec3& cell : cells)
    attempt_.targetReach = std::max(attempt_.targetReach, (cell - middle).norm());
  attempt_.margins =
      marginPlaces(organ, Structure(organ.rest, targetLabel_), 2.5 * attempt_.task->goal.margin);
}

void AttemptReader::keep(std::size_t frames) {
  attempt_.time.resize(frames);
  const double end = attempt_.duration();
  for (InstrumentRecord& one : attempt_.instruments) one.moments.resize(frames);
  if (attempt_.bleeds) attempt_.bled.resize(frames);
  std::erase_if(attempt_.vessels, [&](const VesselStory& v) { return v.cut > end; });
  std::erase_if(attempt_.clips, [&](const ClipPlaced& clip) { return clip.time > end; });
  std::erase_if(attempt_.tissue, [&](const TissueMoment& m) { return m.time > end; });
  if (goal_) goal_->rewind(frames, attempt_);
}

void AttemptReader::rewind(std::size_t frames) {
  if (frames >= attempt_.time.size()) return;
  keep(frames);
  vessels_ = {};
  ++attempt_.undos;
}

// Without a hand the inflow is not clamped or freed, so that a clamp that is on was on all the
// time.
void AttemptReader::endAt(std::size_t frames, const Simulation& simulation) {
  if (frames < attempt_.time.size()) {
    const double rest = attempt_.interval * double(attempt_.time.size() - frames);
    if (std::ranges::any_of(simulation.organs(),
                            [](const auto& o) { return o.organ.vessels.inflowClamped; }))
      attempt_.inflowOccluded = std::max(0.0, attempt_.inflowOccluded - rest);
    keep(frames);
    for (VesselStory& vessel : attempt_.vessels)
      if (vessel.closed && *vessel.closed > attempt_.duration()) vessel.closed.reset();
  }
  finish(simulation);
  attempt_.tissue.back().time = attempt_.duration();
  measureMargins(simulation);
}

ToolMoment AttemptReader::momentOf(const Simulation& simulation, const StepReport& report,
                                   std::size_t t) const {
  const ToolState& state = simulation.tools()[t];
  ToolMoment now;
  now.tip = state.pose() * state.tool->model.tip;
  now.turn = state.pose().rotation;
  now.inHand = state.inHand;
  now.taken = state.inHand || !lies(state.pose(), rests_[t]);
  now.force = t < report.toolForce.size() ? report.toolForce[t].norm() : 0;
  now.squeeze = state.way.to.squeeze, now.pedal = state.way.to.pedal;
  now.works = now.inHand && worksOnOrgan(report, simulation, t);
  for (const OperatedOrgan& organ : simulation.organs())
    now.grips = now.grips || organ.tissue->gripped(std::int32_t(t)) > 0;
  return now;
}

// The account of the tissue, and the pieces that are off by now.
void AttemptReader::takeLedger(const Simulation& simulation) {
  const Ledger ledger = books_.ledgerOf(simulation);
  const TissueSplit all = ledger.tissue();
  attempt_.tissue.push_back({simulation.time(), all.body.volume, all.pieces.volume,
                             all.removed.volume + all.debris.volume, ledger.cut()});
  attempt_.specimens.clear();
  attempt_.margin.reset();
  attempt_.hurt.clear();
  for (std::size_t o = 0; o < ledger.organs.size(); ++o) {
    addSpecimens(ledger.organs[o], o);
    addHurt(ledger.organs[o], o);
  }
  std::ranges::stable_sort(attempt_.specimens, std::greater<>(), &Specimen::volume);
}

// Of the goal's organ its structures count, of the others all tissue.
void AttemptReader::addHurt(const OrganLedger& organ, std::size_t number) {
  if (!attempt_.task) return;
  const auto note = [&](const std::string& name, bool hurt) {
    attempt_.otherStructures = true;
    if (hurt) attempt_.hurt.push_back(name);
  };
  if (number != targetOrgan_) {
    note(organ.name, organ.cut > 0 || organ.tissue.removed.particles > 0);
    return;
  }
  for (const LabelLedger& label : organ.labels)
    if (label.margin && label.label != targetLabel_) note(label.name, *label.margin <= 0);
}

void AttemptReader::addSpecimens(const OrganLedger& organ, std::size_t number) {
  const bool isTarget = targetLabel_ > 0 && number == targetOrgan_;
  for (std::size_t p = 1; p < organ.parts.size(); ++p) {
    Specimen piece{std::int32_t(number), organ.parts[p].tissue.volume, organ.parts[p].tissue.mass,
                   0};
    for (const PartLedger::Share& share : organ.parts[p].labels)
      if (isTarget && share.label == targetLabel_) piece.target = share.tissue.volume;
    attempt_.specimens.push_back(piece);
  }
  for (const LabelLedger& label : organ.labels) {
    if (!isTarget || label.label != targetLabel_) continue;
    attempt_.targetBefore = label.tissue.before.volume;
    if (label.margin && std::isfinite(*label.margin)) attempt_.margin = label.margin;
  }
}

}  // namespace resect

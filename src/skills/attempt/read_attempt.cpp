#include "skills/attempt/read_attempt.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "io/scenario/task_reader.h"
#include "operation/ledger/ledger.h"
#include "operation/live/operation_events.h"
#include "record/course.h"
#include "skills/attempt/goal_watch.h"
#include "skills/attempt/vessel_watch.h"

namespace resect {
namespace {

std::optional<Task> taskOf(RecordingFile& file, const RecordedSetup& setup,
                           const AttemptOptions& options) {
  if (options.task) return options.task;
  const std::string text = file.task();
  if (text.empty()) return {};
  return parseTask(text, file.name() + ", its task", setup.scenario);
}

std::string modelOf(const ScenarioTool& tool) {
  return std::filesystem::path(tool.model).stem().string();
}

// Follows everything that the attempt keeps, frame by frame.
class AttemptReader {
 public:
  AttemptReader(Attempt& attempt, const RecordedSetup& setup, Simulation& simulation)
      : attempt_(attempt),
        books_(setup.scenario, simulation),
        second_(std::max<std::int64_t>(1, std::llround(setup.scenario.frameRate))) {
    attempt_.interval = 1 / setup.scenario.frameRate;
    attempt_.bleeds = simulation.blood().any();
    attempt_.tissueMoves = simulation.moves();
    for (std::size_t t = 0; t < setup.tools.size(); ++t)
      attempt_.instruments.push_back({setup.tools[t].name,
                                      modelOf(setup.scenario.tools[t]),
                                      setup.tools[t].axis.normalized(),
                                      {}});
    if (attempt_.task) goal_.emplace(attempt_.task->goal, setup.scenario, simulation);
    if (attempt_.task && attempt_.task->goal.kind == TaskGoal::Kind::Resect) {
      targetOrgan_ = goalOrgan(attempt_.task->goal, setup.scenario);
      targetLabel_ =
          labelNamed(simulation.organs()[targetOrgan_].organ, attempt_.task->goal.structure);
    }
    addTissue(simulation);
  }

  void add(const Simulation& simulation, const StepReport& report) {
    attempt_.time.push_back(simulation.time());
    for (std::size_t t = 0; t < attempt_.instruments.size(); ++t)
      attempt_.instruments[t].moments.push_back(momentOf(simulation, report, t));
    if (attempt_.bleeds) attempt_.bled.push_back(toCubicMetres(report.blood.ledger.bled));
    attempt_.torn += report.torn;
    vessels_.add(simulation, report, attempt_);
    if (goal_) goal_->add(simulation, attempt_);
    if (simulation.frame() % second_ == 0) addTissue(simulation);
  }

  void finish(const Simulation& simulation) {
    addTissue(simulation);
    vessels_.finish(simulation, attempt_);
    const Ledger ledger = books_.ledgerOf(simulation);
    for (std::size_t o = 0; o < ledger.organs.size(); ++o) addSpecimens(ledger.organs[o], o);
    std::ranges::stable_sort(attempt_.specimens, std::greater<>(), &Specimen::volume);
  }

 private:
  ToolMoment momentOf(const Simulation& simulation, const StepReport& report, std::size_t t) const {
    const ToolState& state = simulation.tools()[t];
    ToolMoment now;
    now.tip = state.pose() * state.tool->model.tip;
    now.turn = state.pose().rotation;
    now.inHand = state.inHand;
    now.force = t < report.toolForce.size() ? report.toolForce[t].norm() : 0;
    now.squeeze = state.way.to.squeeze, now.pedal = state.way.to.pedal;
    now.works = now.inHand && worksOnOrgan(report, simulation, t);
    for (const OperatedOrgan& organ : simulation.organs())
      now.grips = now.grips || organ.tissue->gripped(std::int32_t(t)) > 0;
    return now;
  }

  void addTissue(const Simulation& simulation) {
    if (!attempt_.tissue.empty() && attempt_.tissue.back().time == simulation.time()) return;
    const Ledger ledger = books_.ledgerOf(simulation);
    const TissueSplit all = ledger.tissue();
    attempt_.tissue.push_back({simulation.time(), all.body.volume, all.pieces.volume,
                               all.removed.volume + all.debris.volume, ledger.cut()});
  }

  void addSpecimens(const OrganLedger& organ, std::size_t number) {
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

  Attempt& attempt_;
  LedgerBooks books_;
  std::int64_t second_;
  VesselWatch vessels_;
  std::optional<GoalWatch> goal_;
  std::size_t targetOrgan_ = 0;
  int targetLabel_ = 0;
};

}  // namespace

Attempt readAttempt(const std::filesystem::path& path, const AttemptOptions& options,
                    const Progress& progress) {
  Replay replay(path);
  RecordingFile& file = replay.file();
  const RecordedSetup& setup = replay.setup();
  Attempt attempt;
  attempt.file = path.string();
  attempt.title = setup.scenario.title;
  attempt.scenario = setup.scenario.name;
  attempt.program = file.info().program;
  attempt.learner = options.learner;
  attempt.complete = file.complete();
  attempt.task = taskOf(file, setup, options);
  attempt.undos = int(std::max<std::size_t>(1, file.branches().size())) - 1;
  const std::vector<CourseSpan> course = courseOf(file, file.moment().branch);
  if (course.empty())
    throw error("{}: holds no frames, so there is no attempt to score; record one", path.string());

  Simulation& simulation = replay.simulation();
  if (options.watch) simulation.keepLook();
  replay.goTo(course.front().branch, course.front().first);
  AttemptReader reader(attempt, setup, simulation);
  if (options.watch) options.watch(setup.scenario, simulation, 0);
  StepReport step;
  const double end = double(std::max<std::int64_t>(1, course.back().last));
  for (const CourseSpan& span : course) {
    if (replay.branch() != span.branch) replay.goTo(span.branch, span.first);
    while (simulation.frame() < span.last && replay.step(nullptr, &step)) {
      reader.add(simulation, step);
      if (options.watch) options.watch(setup.scenario, simulation, simulation.time());
      report(progress, double(simulation.frame()) / end);
    }
  }
  reader.finish(simulation);
  return attempt;
}

}  // namespace resect

#include "io/scenario/task_reader.h"

#include <algorithm>

#include "operation/task/measure.h"

namespace resect {
namespace {

constexpr double kFarthestTask = 10;  // m
constexpr std::size_t kMostPlaces = 200;

template <typename List>
std::string listed(const List& all) {
  std::string names;
  for (const auto& one : all) names.append(names.empty() ? "" : ", ").append(wordOf(one));
  return names;
}

void requireTool(const TomlTable& t, const std::string& key, const std::string& name,
                 const Scenario& scenario) {
  std::string there;
  for (const ScenarioTool& tool : scenario.tools) {
    if (modelOf(tool) == name) return;
    there.append(there.empty() ? "" : ", ").append(modelOf(tool));
  }
  t.complain(key, "names \"" + name + "\", and the scenario has no such instrument; it has " +
                      (there.empty() ? "none" : there));
}

TaskPlace readPlace(const TomlTable& t, const OrganSource& organ) {
  TaskPlace place;
  const bool at = t.has("at"), point = t.has("place");
  if (at == point) t.complain(at ? "at" : "place", "is not the only place; give at or place");
  if (at) {
    place.landmark = t.text("at");
    const bool known = std::ranges::count(organ.landmarks, place.landmark, &Landmark::name) > 0;
    if (!known && isBuiltIn(organ))
      t.complain("at", "names the landmark \"" + place.landmark +
                           "\", which the organ lacks; add it to [organ.landmark]");
  } else {
    place.place = t.place("place", kFarthestTask);
    const std::string frame = t.text("frame", "organ");
    if (frame != "organ" && frame != "world")
      t.complain("frame", "is \"" + frame + "\"; use \"organ\" or \"world\"");
    place.inWorld = frame == "world";
  }
  if (t.has("depth")) place.depth = t.number("depth", -kFarthestTask, kFarthestTask);
  t.refuseUnknownKeys();
  return place;
}

void requirePlaces(const TomlTable& t, const TaskGoal& goal) {
  using enum TaskGoal::Kind;
  const std::size_t least = goal.kind == Follow ? 2 : 1;
  const bool needs = goal.kind != Resect && goal.kind != StopBleeding;
  if (needs && goal.places.size() < least)
    t.complain("places",
               fmt::format("has {} places, and \"{}\" takes {} or more; give places = [{{ place = "
                           "[x, y, z] }}, ...]",
                           goal.places.size(), wordOf(goal.kind), least));
  if (!needs && !goal.places.empty())
    t.complain("places", fmt::format("are not used by \"{}\"; leave them out", wordOf(goal.kind)));
}

void readStructure(const TomlTable& t, const OrganSource& organ, TaskGoal& goal) {
  goal.structure = t.text("structure");
  goal.margin = t.has("margin") ? t.length("margin", 0, 0.2) : goal.margin;
  if (std::ranges::count(organ.labels, goal.structure, &OrganLabel::name) > 0) return;
  if (!isBuiltIn(organ)) return;
  t.complain("structure",
             "names \"" + goal.structure + "\", which the organ lacks; mark it by [[organ.label]]");
}

VesselKind readVessel(const TomlTable& t) {
  const std::string word = t.text("vessel", std::string(wordOf(VesselKind::PortalVein)));
  std::string known;
  for (int k = 0; k < kVesselKinds; ++k) {
    if (wordOf(VesselKind(k)) == word) return VesselKind(k);
    known.append(known.empty() ? "" : ", ").append(wordOf(VesselKind(k)));
  }
  t.complain("vessel", "is \"" + word + "\"; use one of " + known);
}

void readRates(const TomlTable& t, TaskGoal& goal) {
  constexpr double kMillilitreAMinute = 1e-6 / 60;  // m^3/s
  const double rate = t.number("rate_ml_min", 0, 1000, 5);
  const double from = t.number("from_ml_min", 0, 10'000, 4 * rate);
  if (from < rate)
    t.complain(
        "from_ml_min",
        fmt::format("is {:g}, and rate_ml_min is {:g}: so little counts as no bleeding; give "
                    "more than that",
                    from, rate));
  goal.rate = kMillilitreAMinute * rate, goal.from = kMillilitreAMinute * from;
}

TaskGoal readGoal(const TomlTable& t, const Scenario& scenario) {
  using enum TaskGoal::Kind;
  TaskGoal goal;
  const std::string word = t.text("kind");
  const auto kind =
      std::ranges::find_if(kGoalKinds, [&](TaskGoal::Kind k) { return wordOf(k) == word; });
  if (kind == kGoalKinds.end())
    t.complain("kind", "is \"" + word + "\"; use one of " + listed(kGoalKinds));
  goal.kind = *kind;
  goal.organ = t.text("organ", scenario.organs[0].source.name);
  const auto organ = std::ranges::find_if(
      scenario.organs, [&](const auto& o) { return o.source.name == goal.organ; });
  if (organ == scenario.organs.end())
    t.complain("organ", "is \"" + goal.organ + "\", and the scenario has no such organ");
  const OrganSource& source = organ->source;
  for (const TomlTable& place : t.tables("places", kMostPlaces))
    goal.places.push_back(readPlace(place, source));
  requirePlaces(t, goal);
  if (goal.kind == Touch || goal.kind == Follow || goal.kind == Transect)
    goal.radius = t.has("radius") ? t.length("radius", 1e-4, 0.2) : goal.radius;
  if (goal.kind == Touch || goal.kind == StopBleeding)
    goal.hold = t.number("hold", 0, 600, goal.hold);
  if (goal.kind == Resect) readStructure(t, source, goal);
  if (goal.kind == StopBleeding) readRates(t, goal);
  if (goal.kind == Transect) {
    goal.normal = t.vec3("normal");
    if (goal.normal.norm() < 1e-9) t.complain("normal", "has no length");
    goal.normal.normalize();
  }
  if (goal.kind == Divide) {
    goal.vessel = readVessel(t);
    goal.thinnest = t.has("thinnest") ? t.length("thinnest", 1e-4, 0.05) : goal.thinnest;
  }
  if ((goal.kind == Divide || goal.kind == StopBleeding) && source.vessels.empty())
    t.complain("kind", "is \"" + word + "\", and the organ \"" + goal.organ +
                           "\" has no vessels; give it vessels, such as vessels = \"built-in\"");
  if (t.has("with")) requireTool(t, "with", goal.with = t.text("with"), scenario);
  if (goal.kind == Follow && t.has("hold_with"))
    requireTool(t, "hold_with", goal.holdWith = t.text("hold_with"), scenario);
  t.refuseUnknownKeys();
  return goal;
}

void requireMeasure(const TomlTable& t, const std::string& id) {
  if (!findMeasure(id)) t.complain(id, "is no measure; the measures are: " + measureNames());
}

// most = number, or { least = number, most = number }.
std::vector<TaskLimit> readLimits(const TomlTable& t) {
  std::vector<TaskLimit> limits;
  for (const std::string& id : t.keys()) {
    requireMeasure(t, id);
    TaskLimit limit{id, {}, {}};
    const MeasureKind& kind = *findMeasure(id);
    if (t.isTable(id)) {
      const TomlTable range = *t.table(id);
      if (range.has("least")) limit.least = range.number("least", -1e9, 1e9);
      if (range.has("most")) limit.most = range.number("most", -1e9, 1e9);
      range.refuseUnknownKeys();
      if (!limit.least && !limit.most)
        t.complain(id, "gives neither least nor most; give one of them");
      if (limit.least && limit.most && *limit.least > *limit.most)
        t.complain(id, "has a least that is above its most; exchange them");
    } else {
      const double value = t.number(id, -1e9, 1e9);
      (kind.better == MeasureKind::Better::More ? limit.least : limit.most) = value;
    }
    limits.push_back(limit);
  }
  return limits;
}

void readBands(const TomlTable& t, Task& task) {
  task.bandRuns = t.integer("runs", 1, 1'000'000);
  task.bandWidth = t.number("deviations", 0, 100, task.bandWidth);
  for (const std::string& id : t.keys()) {
    if (id == "runs" || id == "deviations") continue;
    requireMeasure(t, id);
    const std::vector<double> pair = t.numbers(id, -1e9, 1e9);
    if (pair.size() != 2 || pair[1] < 0)
      t.complain(id, "is not [mean, standard deviation]; give two numbers, the second 0 or more");
    task.bands.push_back({id, pair[0], pair[1]});
  }
}

void readPass(const TomlTable& t, Task& task) {
  if (t.isList("pass"))
    task.pass = t.texts("pass");
  else
    task.pass.assign(1, t.text("pass", "all"));
  for (const std::string& one : task.pass)
    if (one != "all" && one != "goal" && !findMeasure(one))
      t.complain("pass", "names \"" + one +
                             "\"; use \"all\", \"goal\", or names of measures: " + measureNames());
}

}  // namespace

Task readTask(const TomlTable& t, const Scenario& scenario) {
  Task task;
  task.text = t.asText();
  task.teaches = t.text("teaches");
  task.background = t.freeText("background");
  task.steps = t.texts("steps");
  const std::string level = t.text("level", std::string(wordOf(task.level)));
  if (!taskLevel(level))
    t.complain("level", "is \"" + level + "\"; use one of " + listed(kTaskLevels));
  task.level = *taskLevel(level);
  task.instruments = t.texts("instruments");
  for (const std::string& name : task.instruments) requireTool(t, "instruments", name, scenario);
  task.guidance = t.flag("guidance", task.guidance);
  task.familiarisation = t.flag("familiarisation", task.familiarisation);
  task.undo = t.flag("undo", task.undo);
  if (t.has("force_limit")) task.forceLimit = t.number("force_limit", 0, 1000);
  task.forceLimitSource = t.text("force_limit_source", task.forceLimitSource);
  const auto goal = t.table("goal");
  if (!goal) t.complain("goal", "is missing; give [task.goal] with its kind");
  task.goal = readGoal(*goal, scenario);
  if (const auto limits = t.table("limits")) task.limits = readLimits(*limits);
  if (const auto levels = t.table("levels")) {
    for (const TaskLevel one : kTaskLevels)
      if (const auto limits = levels->table(std::string(wordOf(one))))
        task.levels[std::size_t(one)] = readLimits(*limits);
    levels->refuseUnknownKeys();
  }
  if (const auto band = t.table("band")) readBands(*band, task);
  task.published = t.texts("published");
  // Names of shipped files: a recording from outside must not name others.
  for (const std::string& name : task.published)
    if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != name.npos)
      t.complain("published", "names \"" + name + "\"; give names of files in data/bands");
  readPass(t, task);
  t.refuseUnknownKeys();
  return task;
}

Task parseTask(const std::string& text, const std::string& name, const Scenario& scenario) {
  return readTask(TomlTable::parse(text, name), scenario);
}

}  // namespace resect

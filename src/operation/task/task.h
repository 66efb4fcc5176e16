// A task: what is to be done in a scenario, and what counts as done well, as plain data.
//
// Places are given in the organ's own coordinates, so a task fits any organ that has what it names.
// io/scenario/task_reader.h reads a task; docs/scenarios.md lists the keys.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "base/vec.h"

namespace resect {

// A point of an organ at rest.
struct TaskPlace {
  std::string landmark;       // of the organ; "": `place` counts
  Vec3 place = Vec3::Zero();  // fractions of the organ's box; m, world, if `inWorld`
  bool inWorld = false;
  // If given, the point is moved to this depth under the surface point nearest to it, m; 0: onto
  // the surface, negative: above it.
  std::optional<double> depth;
};

struct TaskGoal {
  enum class Kind {
    Touch,   // bring the tip to each of `places` in turn, and hold it there
    Follow,  // cut along the line through `places`
    Resect,  // take out `structure` in one piece, with a margin
    StopBleeding,
    Divide,   // cut the vessel at places[0] between two clips
    Transect  // part the organ along a plane through places[0]
  };
  Kind kind = Kind::Touch;
  std::string organ;  // "": the first
  std::vector<TaskPlace> places;
  double radius = 0.006;        // m: of a target, and of the strip along a line or plane
  double hold = 1;              // s: that a target is to be held, or that nothing bleeds
  std::string structure;        // name of a label of the organ
  double margin = 0.01;         // m
  double rate = 5e-6 / 60;      // m^3/s: less than this counts as no bleeding
  double from = 20e-6 / 60;     // m^3/s: it must have bled so fast before it can be stopped
  Vec3 normal = Vec3::UnitX();  // of the plane; unit, in the world
  VesselKind vessel = VesselKind::PortalVein;
  double thinnest = 0.002;  // m: least diameter of the vessel
  std::string with;         // model of the instrument that is to do it; "": any
  std::string holdWith;     // model of the one that is to hold the tissue; "": none
};
// Words for the kinds, as in files.
std::string_view wordOf(TaskGoal::Kind kind);
inline constexpr std::array kGoalKinds{TaskGoal::Kind::Touch,  TaskGoal::Kind::Follow,
                                       TaskGoal::Kind::Resect, TaskGoal::Kind::StopBleeding,
                                       TaskGoal::Kind::Divide, TaskGoal::Kind::Transect};

// A measure (operation/task/measure.h) that must stay between two values.
struct TaskLimit {
  std::string measure;
  std::optional<double> least, most;
};

// Mean and standard deviation of a measure in runs that the teacher has marked as reference.
struct TaskBand {
  std::string measure;
  double mean = 0, deviation = 0;
};

enum class TaskLevel { Easy, Medium, Hard };
inline constexpr std::array kTaskLevels{TaskLevel::Easy, TaskLevel::Medium, TaskLevel::Hard};
std::string_view wordOf(TaskLevel level);
std::optional<TaskLevel> taskLevel(std::string_view word);

struct Task {
  std::string teaches;             // one sentence
  std::vector<std::string> steps;  // what is to be done next, a line each
  std::string background;          // for the page of what it teaches; may be empty
  TaskGoal goal;
  TaskLevel level = TaskLevel::Medium;   // unless another one is asked for
  std::vector<std::string> instruments;  // models that may be in hand; empty: all
  bool guidance = true;                  // target and next step may be shown
  bool familiarisation = true;           // the first attempt is not graded
  bool undo = true;                      // work may be taken back
  std::optional<double> forceLimit;  // N: above it, a force counts as an error; see forceLimitOf()
  std::string forceLimitSource = "setting of the task";
  std::vector<TaskLimit> limits;                 // of all levels
  std::array<std::vector<TaskLimit>, 3> levels;  // per level: these replace those in `limits`
  std::vector<TaskBand> bands;                   // the task's own
  double bandWidth = 2;                // standard deviations from the mean that still pass
  int bandRuns = 0;                    // from so many runs
  std::vector<std::string> published;  // names of files in data/bands
  // What a pass takes besides the goal: names of measures; {"all"}: every limit and band.
  std::vector<std::string> pass = {"all"};
  // The text that the task was read from, as TOML; recordings keep it.
  std::string text;
};

// The limits that count at a level.
std::vector<TaskLimit> limitsAt(const Task& task, TaskLevel level);
// The most that a measure may be at the task's own level; none: it has no such limit.
std::optional<double> mostOf(const Task& task, std::string_view measure);

// The force above which a force counts as an error at the task's own level, and whose it is: the
// most of `force_peak_n` there, or else the task's `force_limit`. None if it has neither.
struct ForceLimit {
  double force = 0;  // N
  std::string source;
};
std::optional<ForceLimit> forceLimitOf(const Task& task);

}  // namespace resect

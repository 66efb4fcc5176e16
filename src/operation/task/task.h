// A task: what is to be done in a scenario, and what counts as done well, as plain data.
//
// Places are usually given in the organ's own coordinates, so that a task fits any organ that has
// the landmarks and structures that the task names. io/scenario/task_reader.h reads a task
// from a file; docs/scenarios.md lists the keys of such a file.
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
  std::string landmark;       // name of a landmark of the organ; "": `place` is used
  Vec3 place = Vec3::Zero();  // fractions of the organ's box; if inWorld: world, m
  bool inWorld = false;
  // If given, the point is moved to this depth, m, under the nearest point of the surface. 0: onto
  // the surface; negative: above the surface.
  std::optional<double> depth;
};

struct TaskGoal {
  enum class Kind {
    Touch,   // bring the tip to each of `places` in turn, and hold it there
    Follow,  // cut along the line through `places`
    Resect,  // take out `structure` in one piece, with a margin
    StopBleeding,
    Divide,   // cut the vessel at places[0] between two clips
    Transect  // divide the organ along a plane through places[0]
  };
  Kind kind = Kind::Touch;
  std::string organ;  // its name; "": the first organ
  std::vector<TaskPlace> places;
  double radius = 0.006;        // m: greatest distance allowed from target, line or plane
  double hold = 1;              // s: how long a tip must stay, or bleeding must be stopped
  std::string structure;        // a structure of the organ, by the name of its label
  double margin = 0.01;         // m: least margin round `structure`
  double rate = 5e-6 / 60;      // m^3/s: a smaller blood flow counts as no bleeding
  double from = 20e-6 / 60;     // m^3/s: the bleeding to be stopped must first reach this flow
  Vec3 normal = Vec3::UnitX();  // of the plane; unit, world
  VesselKind vessel = VesselKind::PortalVein;
  double thinnest = 0.002;  // m: least diameter of the vessel
  std::string with;         // model of the instrument that must reach the goal; "": any
  std::string holdWith;     // model of the instrument that must hold the tissue; "": none
};
// The word for a kind in files.
std::string_view wordOf(TaskGoal::Kind kind);
inline constexpr std::array kGoalKinds{TaskGoal::Kind::Touch,  TaskGoal::Kind::Follow,
                                       TaskGoal::Kind::Resect, TaskGoal::Kind::StopBleeding,
                                       TaskGoal::Kind::Divide, TaskGoal::Kind::Transect};

// A measure that must stay between two values.
struct TaskLimit {
  std::string measure;  // MeasureKind::id
  std::optional<double> least, most;
};

// Mean and standard deviation of a measure in reference runs.
struct TaskBand {
  std::string measure;  // MeasureKind::id
  double mean = 0, deviation = 0;
};

enum class TaskLevel { Easy, Medium, Hard };
inline constexpr std::array kTaskLevels{TaskLevel::Easy, TaskLevel::Medium, TaskLevel::Hard};
// The word for a level in files, and the level for a word; nothing if the word is none of these.
std::string_view wordOf(TaskLevel level);
std::optional<TaskLevel> taskLevel(std::string_view word);

struct Task {
  std::string teaches;             // what the task teaches, one sentence
  std::vector<std::string> steps;  // instructions, one line for each step
  std::string background;          // text for the page about the task; may be empty
  TaskGoal goal;
  TaskLevel level = TaskLevel::Medium;   // unless the user chooses another one
  std::vector<std::string> instruments;  // models that may be in hand; empty: all
  bool guidance = true;                  // target and next step may be shown
  bool familiarisation = true;           // the first attempt is not graded
  bool undo = true;                      // undo is allowed
  std::optional<double> forceLimit;      // N: a larger force counts as an error; see forceLimitOf()
  std::string forceLimitSource = "setting of the task";
  std::vector<TaskLimit> limits;  // for all levels
  // Further limits for each level. At its level, such a limit replaces the limit of the same
  // measure in `limits`.
  std::array<std::vector<TaskLimit>, 3> levels;
  std::vector<TaskBand> bands;  // set by the task itself; see also `published`
  double bandWidth = 2;         // largest allowed distance from the mean, in standard deviations
  int bandRuns = 0;             // number of reference runs that gave `bands`
  std::vector<std::string> published;  // names of files in data/bands with published bands
  // An attempt passes if it reaches the goal, and keeps the limits and bands of these measures.
  // Each measure is given by its `id`. {"all"}: every limit and band must be kept.
  std::vector<std::string> pass = {"all"};
  // The text, in TOML, from which the task was read. Recordings keep this text.
  std::string text;
};

// The limits that apply at a level.
std::vector<TaskLimit> limitsAt(const Task& task, TaskLevel level);
// The largest allowed value of a measure at the task's own level; nothing if there is no such
// limit.
std::optional<double> mostOf(const Task& task, std::string_view measure);

// The limit of force at the task's own level: a larger force counts as an error. It is the largest
// allowed value of the measure force_peak_n. If that measure has no largest allowed value, the
// limit is Task::forceLimit. If Task::forceLimit is not set either, there is no limit.
struct ForceLimit {
  double force = 0;    // N
  std::string source;  // where the limit comes from, for people
};
std::optional<ForceLimit> forceLimitOf(const Task& task);

}  // namespace resect

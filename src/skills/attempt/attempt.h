// An attempt at a task, as far as a recording shows it: plain data from which all measures follow.
//
// readAttempt() (skills/attempt/read_attempt.h) makes it by playing the recording. So an old
// recording can be scored again, by new measures too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/anatomy.h"
#include "operation/ledger/wound_faces.h"
#include "operation/task/task.h"
#include "skills/metrics/track.h"

namespace resect {

// An instrument at the end of a frame.
struct ToolMoment {
  Vec3 tip = Vec3::Zero();  // world, m
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  double force = 0;  // N, of the tissue on the instrument
  double squeeze = 0, pedal = 0;
  bool inHand = false;  // and able to touch
  // In hand, or carried over the organ by a hand that points at it: away from where it lies.
  bool taken = false;
  bool works = false;  // it touches or cuts an organ
  bool grips = false;  // it holds tissue
};

struct InstrumentRecord {
  std::string name;   // for people
  std::string model;  // as tasks name it: "scalpel"
  Vec3 axis = Vec3::UnitZ();
  std::vector<ToolMoment> moments;  // one per frame
  // s: in hand, and its tip outside the picture; none: nobody looked, or it was not recorded.
  std::optional<double> unseen = {};
};

// What became of a vessel that was cut.
struct VesselStory {
  std::int32_t organ = 0, segment = -1;
  VesselKind kind = VesselKind::PortalVein;
  std::string name;                              // for people, such as "right portal vein"
  double diameter = 0;                           // m
  Vec3 place = Vec3::Zero();                     // of its middle, at rest, m
  double cut = 0;                                // s: when it was first cut
  int tool = -1;                                 // that was cutting then; -1: not known
  bool before = false;                           // the operation began with this cut
  bool clippedRoot = false, clippedFar = false;  // before it was cut
  bool severed = false;
  std::optional<double> closed;  // s: since when all its ends have been closed by clips or heat
  double bled = 0;               // m^3
};

struct ClipPlaced {
  double time = 0;  // s
  std::int32_t organ = 0, segment = -1;
  Vec3 place = Vec3::Zero();  // at rest, m
  std::string vessel;         // for people
  double diameter = 0;        // of the vessel, m
};

// Tissue and blood after a frame; once a second, and at the end.
struct TissueMoment {
  double time = 0;                           // s
  double body = 0, pieces = 0, removed = 0;  // m^3, of all organs; removed: debris too
  double cut = 0;                            // m^2
};

// A piece that has come off an organ.
struct Specimen {
  std::int32_t organ = 0;
  double volume = 0, mass = 0;  // m^3, kg
  double target = 0;            // m^3 of the goal's structure in it
};

// A moment at which the instrument of the goal was at work, seen from the goal's line or plane.
struct WorkMoment {
  std::size_t frame = 0;
  double along = 0;  // m along the line, from its beginning
  double off = 0;    // m from the line, aside; or from the plane
};

// How near the goal was, frame by frame.
struct GoalTrace {
  // Per target and frame: distance of the nearest tip that counts, m; infinite without one.
  std::vector<std::vector<float>> distance;
  // Of the targets, line or plane, m: at rest; and in the world when the first instrument went to
  // work, by when the tissue has settled.
  std::vector<Vec3> restPlaces, places;
  double lineLength = 0;  // m
  std::vector<WorkMoment> work;
  std::vector<char> held;  // per frame: the instrument that is to hold tissue grips some
};

struct Attempt {
  std::string file, title, scenario, program;
  std::string learner;         // pseudonym; may be empty
  std::optional<Task> task;    // none: the recording has none, and none was given
  bool complete = true;        // the recording was ended, and not cut short
  int undos = 0;               // branches that begin where work was taken back
  double interval = 1.0 / 60;  // s, of a frame
  std::vector<double> time;    // at the end of each frame, s from the start
  std::vector<InstrumentRecord> instruments;

  bool bleeds = false;               // an organ has vessels
  std::vector<double> bled;          // per frame: lost so far, m^3
  std::vector<VesselStory> vessels;  // in the order in which they were cut
  std::vector<ClipPlaced> clips;
  double inflowOccluded = 0;  // s
  int inflowCycles = 0;

  bool tissueMoves = false;
  std::vector<TissueMoment> tissue;
  std::vector<Specimen> specimens;  // the largest first
  // Other structures than the goal's: whether there are any, and names of those that were cut, or
  // of which something was destroyed.
  bool otherStructures = false;
  std::vector<std::string> hurt;
  std::int64_t torn = 0;         // bonds
  double targetBefore = 0;       // m^3 of the goal's structure before the operation
  std::optional<double> margin;  // m, of the goal's structure; none if nothing was cut
  // Where the cuts came near the goal's structure; and this: middle and reach, at rest, m.
  std::vector<MarginPlace> margins;
  Vec3 targetMiddle = Vec3::Zero();
  double targetReach = 0;
  GoalTrace goal;

  double duration() const { return time.empty() ? 0 : time.back(); }
};

// The stretches in which an instrument was taken: its whole way, hovering included.
std::vector<Track> tracksOf(const Attempt& attempt, const InstrumentRecord& instrument);
// The first and the last frame in which any instrument was at work; nothing if none was.
std::optional<SampleRange> workOf(const Attempt& attempt);
// Rate of bleeding at the end of a frame, mean over the second before it, m^3/s.
double bleedingRate(const Attempt& attempt, std::size_t frame);
// The frame at whose end this rate was largest; nothing if nothing bled.
std::optional<std::size_t> worstBleeding(const Attempt& attempt);

}  // namespace resect

// An attempt at a task, as a recording shows it: plain data from which all measures are computed.
//
// readAttempt() (skills/attempt/read_attempt.h) makes an Attempt by playing the recording: it
// computes the recorded frames again. So an old recording can also be scored by measures that were
// added later. "At rest" and "in rest space" mean: in the positions before any deformation. The
// goal's structure is the structure that the goal of the task names, such as a tumour.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/anatomy.h"
#include "operation/ledger/wound_faces.h"
#include "operation/task/task.h"
#include "skills/metrics/track.h"

namespace resect {

// State of an instrument at the end of a frame.
struct ToolMoment {
  Vec3 tip = Vec3::Zero();  // world, m
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  double force = 0;  // of the tissue on the instrument, N
  double squeeze = 0, pedal = 0;
  bool inHand = false;  // the instrument is in hand and can touch tissue
  // The instrument is in hand, or it is away from its rest pose, for example because it hovers over
  // the organ.
  bool taken = false;
  bool works = false;  // the instrument touches or cuts an organ
  bool grips = false;  // the instrument holds tissue
};

struct InstrumentRecord {
  std::string name;                 // for people
  std::string model;                // name of its model file, by which tasks name it: "scalpel"
  Vec3 axis = Vec3::UnitZ();        // from tip to handle, unit, in the instrument's frame
  std::vector<ToolMoment> moments;  // one per frame
  // Time during which the instrument was in hand and its tip was outside the picture, s. None if
  // there was no picture, or if the recording lacks this time.
  std::optional<double> unseen = {};
};

// The history of a vessel that was cut.
struct VesselStory {
  std::int32_t organ = 0, segment = -1;
  VesselKind kind = VesselKind::PortalVein;
  std::string name;           // for people, such as "right portal vein"
  double diameter = 0;        // m
  Vec3 place = Vec3::Zero();  // middle of the cut, at rest, m
  double cut = 0;             // time of the first cut, s
  int tool = -1;              // number of the tool that made the first cut; -1: unknown
  bool before = false;        // whether it was cut before the operation began
  // Whether the vessel had been closed when it was cut. clippedRoot: on the side of the root of its
  // tree of vessels. clippedFar: on the other side of the cut.
  bool clippedRoot = false, clippedFar = false;
  bool severed = false;
  // Time since which all its cut ends have been closed by clips or heat, s; none: an end is open.
  std::optional<double> closed;
  double bled = 0;  // volume of blood that the vessel has lost, m^3
};

struct ClipPlaced {
  double time = 0;  // s
  std::int32_t organ = 0, segment = -1;
  Vec3 place = Vec3::Zero();  // at rest, m
  std::string vessel;         // for people
  double diameter = 0;        // of the vessel, m
};

// Amounts of tissue after a frame; recorded once per simulated second, and at the end.
struct TissueMoment {
  double time = 0;  // s
  // Volumes, m^3, summed over all organs. body: the largest part of each organ. pieces: parts that
  // came off. removed: destroyed tissue and debris; debris are loose parts that are too small to be
  // a piece.
  double body = 0, pieces = 0, removed = 0;
  double cut = 0;  // area cut or torn, m^2
};

// A piece that has come off an organ.
struct Specimen {
  std::int32_t organ = 0;
  double volume = 0, mass = 0;  // m^3, kg
  double target = 0;            // volume of the goal's structure in the piece, m^3
};

// A frame in which an instrument worked that the goal accepts for the cut. The position of the
// instrument is given relative to the goal's line or plane.
struct WorkMoment {
  std::size_t frame = 0;
  double along = 0;  // position along the line, m from its beginning
  double off = 0;    // distance from the line or plane, m
};

// How near the instruments were to the goal, frame by frame.
struct GoalTrace {
  // Distance from a target to the nearest tip, m. First index: target; second index: frame. Only
  // instruments that are in hand and that the goal accepts count. Infinite if there is no such
  // instrument.
  std::vector<std::vector<float>> distance;
  // Positions, m. Depending on the kind of goal, they are the positions of the targets, of points
  // along the line at most 3 mm apart, or of the point through which the plane is laid. restPlaces:
  // in rest space. places: in the world, at the end of the last frame before an instrument begins
  // to work. By then the tissue has sunk under its weight and lies still.
  std::vector<Vec3> restPlaces, places;
  double lineLength = 0;  // m
  std::vector<WorkMoment> work;
  std::vector<char> held;  // per frame: 1 if the instrument TaskGoal::holdWith grips tissue
};

struct Attempt {
  std::string file, title, scenario, program;
  std::string learner;         // pseudonym; may be empty
  std::optional<Task> task;    // none: neither recorded nor given
  bool complete = true;        // whether the recording is complete, not truncated
  int undos = 0;               // number of times that work was taken back
  double interval = 1.0 / 60;  // duration of a frame, s
  std::vector<double> time;    // at the end of each frame, s from the start
  std::vector<InstrumentRecord> instruments;

  bool bleeds = false;               // whether an organ has vessels
  std::vector<double> bled;          // per frame: blood lost so far, m^3
  std::vector<VesselStory> vessels;  // in the order in which they were cut
  std::vector<ClipPlaced> clips;
  double inflowOccluded = 0;  // time during which the inflow of blood was clamped, s
  int inflowCycles = 0;       // number of times the inflow of blood was clamped

  bool tissueMoves = false;
  std::vector<TissueMoment> tissue;
  std::vector<Specimen> specimens;  // the largest first
  // otherStructures: whether there are structures or organs besides the goal's own. hurt: names of
  // the other structures that a cut or a removal of tissue reached, and names of the other organs
  // that were cut or lost tissue.
  bool otherStructures = false;
  std::vector<std::string> hurt;
  std::int64_t torn = 0;  // number of torn bonds, the connections of neighbouring cells
  // Volume of the goal's structure before the operation, m^3.
  double targetBefore = 0;
  // Least distance of the goal's structure from a face that was cut, or bared by removing tissue,
  // m; none if there is no such face.
  std::optional<double> margin;
  // margins: points of faces that were cut, or bared by removing tissue. The distance of these
  // points from the goal's structure is less than 2.5 times TaskGoal::margin. targetMiddle: mean of
  // the structure's cell centres. targetReach: largest distance of a cell centre from targetMiddle.
  // Positions and distances are in rest space, m.
  std::vector<MarginPlace> margins;
  Vec3 targetMiddle = Vec3::Zero();
  double targetReach = 0;
  GoalTrace goal;

  double duration() const { return time.empty() ? 0 : time.back(); }
};

// The tracks of an instrument: one for each period in which it was taken (ToolMoment::taken). A
// track includes hovering.
std::vector<Track> tracksOf(const Attempt& attempt, const InstrumentRecord& instrument);
// The first and the last frame in which any instrument was at work; none if no instrument was.
std::optional<SampleRange> workOf(const Attempt& attempt);
// Mean rate of bleeding in the last second before the end of a frame, m^3/s.
double bleedingRate(const Attempt& attempt, std::size_t frame);
// The frame at the end of which bleedingRate() was largest; none if nothing bled.
std::optional<std::size_t> worstBleeding(const Attempt& attempt);

}  // namespace resect

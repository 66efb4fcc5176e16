// A scenario: the set-up of an operation and the motions of its tools, as plain data.
// io/scenario/scenario_file.h reads one from a file.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/structure_kind.h"
#include "geometry/pose.h"
#include "operation/task/task.h"
#include "operation/way/organ_way.h"
#include "simulation/simulation.h"
#include "tissue/elastic/elastic_tissue.h"

namespace resect {

// A structure of the organ, such as a tumour, and the region of the cells that belong to it.
struct OrganLabel {
  int label = 1;     // 1 to 255
  std::string name;  // of the structure; may be empty
  Region region;

  template <class Visitor>
  void visit(Visitor& v) {
    v("label", label), v("name", name), v("region", region);
  }
};

// A structure of the organ that is given by a model file in the coordinates of the organ's file: a
// vessel, whose centre lines are taken, or another structure, whose inside gets a label.
struct BroughtStructure {
  StructureKind kind = StructureKind::Tumour;
  int label = 0;     // 1 to 255; 0 for vessels and cavities
  std::string name;  // of the label
  std::string file;
  std::string part;  // names of parts, one a line; "": all
  double unit = 1;   // metres per unit of the file
};

// A straight cut that an organ has before the operation begins: what lies between a line and the
// same line `depth` farther on.
struct OrganWound {
  // The line's ends: fractions of the organ's box at rest, or m, world, if `inWorld`.
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  bool inWorld = false;
  Vec3 into = -Vec3::UnitY();  // unit, world
  double depth = 0;            // m

  template <class Visitor>
  void visit(Visitor& v) {
    v("from", from), v("to", to), v("inWorld", inWorld), v("into", into), v("depth", depth);
  }
};

// Where an organ comes from, how it is placed, and the size of its cells.
struct OrganSource {
  std::string name = "organ";     // its name in the scenario
  std::string beside;             // organ whose pose in the room it takes; "": it uses `pose`
  std::string file = "liver";     // a built-in organ (isBuiltIn), a model file or particle file
  std::string part;               // name of a part of the model file; "": all parts
  double unit = 1;                // metres per unit of the file
  bool repair = false;            // close the holes of an open mesh instead of refusing it
  std::optional<double> spacing;  // side of a cell, m; give this or dims
  std::optional<Vec3i> dims;      // samples per axis of the thesis's grid over the bounding box
  // A particle file contains cells. If `resample` is true, new cells are made instead of them, by
  // spacing or dims.
  bool resample = false;
  Pose pose;            // the rotation applies before onTable and settle, the position after them
  bool onTable = true;  // put it on the table top, y = 0, with its box centred over the origin
  bool settle = true;   // if onTable: roll it to the nearest pose in which it lies still
  OrganSettings settings;
  // Vessels, with which the organ bleeds: "" none, kBuiltInVessels, or a file of vessels
  // (io/vessels_file.h) in the coordinates of the organ's file, in mm.
  std::string vessels;
  // These are added to the landmarks and labels of a particle file. Where the regions of labels
  // overlap, the last one counts.
  std::vector<Landmark> landmarks;
  std::vector<OrganLabel> labels;
  std::vector<OrganWound> wounds;
  // Not kept in recordings, which hold the cells and vessels that were made.
  std::vector<BroughtStructure> structures;
  bool smallVessels = true;  // grow from vessels among these
  // Sentences for people about how all this was chosen; not kept either.
  std::vector<std::string> notes;

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("beside", beside), v("file", file), v("part", part), v("unit", unit);
    v("repair", repair), v("spacing", spacing), v("dims", dims), v("resample", resample);
    v("pose", pose), v("onTable", onTable), v("settle", settle), v("settings", settings);
    v("vessels", vessels);
    v("landmarks", landmarks), v("labels", labels), v("wounds", wounds);
  }
};

// The organs that come with Resect, and whether the source is one of them.
inline constexpr std::string_view kBuiltInOrgans[] = {"liver", "gallbladder"};
inline bool isBuiltIn(const OrganSource& source) {
  return std::ranges::find(kBuiltInOrgans, source.file) != std::end(kBuiltInOrgans);
}
// Whether the source is a built-in organ that comes with vessels; and the names of these, for
// messages.
inline constexpr std::string_view kBuiltInVessels = "built-in";
inline bool isVesselsFile(const OrganSource& source) {
  return !source.vessels.empty() && source.vessels != kBuiltInVessels;
}
inline bool hasVessels(const OrganSource& source) { return source.file == "liver"; }
inline std::string organsWithVessels() { return "liver"; }
std::string builtInOrgans();  // "liver, gallbladder", for messages

// Pose, squeeze and pedal of a tool at one time. Between two keys rotations are interpolated along
// the shorter great circle, and all else linearly.
struct ToolKey {
  double time = 0;     // s from the start
  Pose pose;           // of the tool's frame, whose origin is the tip; world
  double squeeze = 0;  // of the tool's jaws: 0 wide open, 1 closed
  double pedal = 0;    // of an energy device: 0 released, 1 pressed

  template <class Visitor>
  void visit(Visitor& v) {
    v("time", time), v("pose", pose), v("squeeze", squeeze), v("pedal", pedal);
  }
};

// How instruments act. Thesis: tissue is still, each instrument removes what it touches, and only
// one instrument is in hand at a time. Operation: each instrument acts by its working parts.
enum class OperationMode { Thesis, Operation };

struct ScenarioTool {
  std::string model;  // path or name of its description file (.toml)
  // If given, replaces the response in the description file. "": the tool's working parts act.
  // "remove": the tool removes what it touches.
  std::optional<std::string> response;
  Pose rest;  // where it lies while not in hand
  // The keys in ascending order of time. The tool is in hand from the first key to the last one.
  std::vector<ToolKey> keys;
  // If given, the keys are made of it when the organs are loaded (operation/way/place_ways.h). Not
  // kept in recordings, which hold these keys.
  std::optional<OrganWay> way = {};

  template <class Visitor>
  void visit(Visitor& v) {
    v("model", model), v("response", response), v("rest", rest), v("keys", keys);
  }
};

// The material of the cells with a label.
struct LabelMaterial {
  int label = 1;  // 1 to 255
  TissueMaterial material;

  template <class Visitor>
  void visit(Visitor& v) {
    v("label", label), v("material", material);
  }
};

// How the organ's tissue moves.
struct TissueSetup {
  bool elastic = false;  // false: the tissue does not move, as in the original system
  TissueMaterial material = liverTissue();  // of label 0, and of labels not in `materials`
  TissueSettings settings;
  std::vector<TissueAttachment> attachments;
  std::vector<LabelMaterial> materials;  // at most one per label
  // A sentence for people about each older key that was read; not kept in recordings.
  std::vector<std::string> notes;

  const TissueMaterial& materialOf(int label) const {
    for (const LabelMaterial& one : materials)
      if (one.label == label) return one.material;
    return material;
  }

  template <class Visitor>
  void visit(Visitor& v) {
    v("elastic", elastic), v("material", material), v("settings", settings);
    v("attachments", attachments), v("materials", materials);
  }
};

struct ScenarioOrgan {
  OrganSource source;
  TissueSetup tissue;

  template <class Visitor>
  void visit(Visitor& v) {
    v("source", source), v("tissue", tissue);
  }
};

// Springs that hold two organs together. Each leads from a particle of the first organ to the
// nearest particle of the second organ.
struct OrganJoint {
  std::string organs[2];    // names of the two organs
  double reach = 0.01;      // m: particles farther apart at rest are not joined
  double stiffness = 1000;  // of all springs together, N/m

  template <class Visitor>
  void visit(Visitor& v) {
    v("first", organs[0]), v("second", organs[1]), v("reach", reach), v("stiffness", stiffness);
  }
};

struct Scenario {
  std::string name;         // the file's name without extension
  std::string file;         // the file that it was read from; "": it was not read from a file
  std::string title;        // one line for people
  std::string description;  // what the scenario shows, for people
  // What must happen for the title to be true: words of kPromises (operation/promises.h). Not kept
  // in recordings.
  std::vector<std::string> promises = {};
  OperationMode mode = OperationMode::Thesis;
  std::vector<ScenarioOrgan> organs = std::vector<ScenarioOrgan>(1);  // at least one
  std::vector<OrganJoint> joints;  // hold moving tissue together; still tissue needs none
  std::vector<ScenarioTool> tools;
  double frameRate = 60;  // frames per simulated second, 1 to 1000
  double duration = 1;    // s
  // s: if given, the duration lasts so long after the last key of any tool; see endAfterKeys().
  std::optional<double> after = {};   // not kept in recordings
  bool table = true, toolBox = true;  // whether the room has a table, and a tool box
  // What stands round the organs in pictures: "table", or "field", an opened abdomen. Forces and
  // cuts are the same. A recording keeps it as text.
  std::string setting = "table";
  std::string view = "surgeon";  // name of the camera's view (docs/scenarios.md)
  std::optional<Aabb> closeUp;   // box that pictures show, world, m; empty: the organs
  // What is to be done. A recording keeps it as text (RecordingFile::task()), not among the fields.
  std::optional<Task> task;

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("title", title), v("description", description), v("mode", mode);
    v("organs", organs), v("joints", joints), v("tools", tools), v("frameRate", frameRate);
    v("duration", duration), v("table", table), v("toolBox", toolBox), v("view", view);
    v("closeUp", closeUp);
  }
};

// Each of these throws Error unless all numbers are in their ranges (setting_ranges.h) and all
// names of organs are known. They are for scenarios that a program has made. When a scenario is
// read from a file, its reader makes the same checks (io/scenario/scenario_file.h).
void requireSound(const OrganSource& source);
void requireSound(const TissueSetup& tissue);
void requireSound(const Scenario& scenario);

// Whether any tissue moves.
bool moves(const Scenario& scenario);
// The names of Scenario::setting.
constexpr const char* kSettingNames = "table or field";
bool isSetting(std::string_view name);
// Whether pictures show the operative field. Thesis mode always has the table.
bool showsField(const Scenario& scenario);
// Removes all organs but the first, and all joints.
void keepFirstOrgan(Scenario& scenario);
// Replaces all organs by one. Its tissue moves as that of the first organ did, without the
// attachments and the labels' materials, whose places and labels were those of the old organ. If it
// is of another file, the description and the close-up go too.
void replaceOrgans(Scenario& scenario, const OrganSource& source);
// Sets the spacing of the first organ, m, and drops its dims. Scales the spacings of the other
// organs in proportion. An organ that has dims instead of a spacing keeps its dims. before: the
// first organ's spacing until now, m.
void setSpacing(Scenario& scenario, double before, double spacing);
// If the scenario is to end some time after its last key, sets its duration to that, rounded up to
// a tenth of a second.
void endAfterKeys(Scenario& scenario);
// Makes the tissue of all organs elastic, and sets operation mode.
void makeElastic(Scenario& scenario);
// Makes the tissue of all organs still, and sets operation mode.
void makeStill(Scenario& scenario);
// Makes the tissue of all organs still, and sets thesis mode.
void makeThesis(Scenario& scenario);

// Pose, squeeze and pedal of a tool at a time, s, and whether it is in hand then.
ToolInput toolInputAt(const ScenarioTool& tool, double time);

// Input of the frame with number `frame`, counted from 0; it ends at (frame + 1) / frameRate, s. In
// thesis mode only one tool is in hand: the first one whose keys say so.
FrameInput frameInput(const Scenario& scenario, std::int64_t frame);
// Number of frames, at least 1.
std::int64_t frameCount(const Scenario& scenario);

}  // namespace resect

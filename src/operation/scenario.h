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

// A structure that belongs to an organ and is given by a model file, in the coordinates of the
// organ's file. If it is a vessel, its centre lines are used. If it is a cavity, it is cut out of
// the organ's tissue. Otherwise the particles inside the structure get a label.
struct BroughtStructure {
  StructureKind kind = StructureKind::Tumour;
  int label = 0;     // 1 to 255; 0 for vessels and cavities, which have no label
  std::string name;  // of the label
  std::string file;
  std::string part;  // names of parts, one per line; "": all
  double unit = 1;   // metres per unit of the file's coordinates
};

// A straight cut that an organ has before the operation begins. The cut is the rectangle or
// parallelogram between a line and the same line moved by `depth` in the direction `into`.
struct OrganWound {
  // The line's ends, in fractions of the organ's box at rest; if inWorld, in world coordinates, m.
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  bool inWorld = false;
  Vec3 into = -Vec3::UnitY();  // unit, world
  double depth = 0;            // m

  template <class Visitor>
  void visit(Visitor& v) {
    v("from", from), v("to", to), v("inWorld", inWorld), v("into", into), v("depth", depth);
  }
};

// Where an organ comes from, how it is placed, the size of its cells, and what belongs to it.
struct OrganSource {
  std::string name = "organ";     // its name in the scenario
  std::string beside;             // name of an organ whose pose is used; "": `pose` is used
  std::string file = "liver";     // a built-in organ (isBuiltIn), a model file or particle file
  std::string part;               // name of a part of the model file; "": all parts
  double unit = 1;                // metres per unit of the file
  bool repair = false;            // true: holes are closed; false: holes are an error
  std::optional<double> spacing;  // side of a cell, m; give this or dims
  // true: a small organ gets smaller cells than `spacing`, so that it has at least kFewestParticles
  // (collision/coarsest_cell.h). `spacing` is then changed. Not kept in recordings.
  bool finerIfSmall = false;
  std::optional<Vec3i> dims;  // samples along each axis of the bounding box (organ/discretize.h)
  // A particle file contains cells. If `resample` is true, the organ gets new cells, which are made
  // from the surface of the cells in the file. `spacing` or `dims` gives their size.
  bool resample = false;
  // The organ is placed in this order: pose.rotation, settle, onTable, pose.position. onTable: the
  // organ is put on the table's top, y = 0, with its box centred over the origin. settle: if
  // onTable, the organ first rolls to the nearest pose in which it lies still.
  Pose pose;
  bool onTable = true;
  bool settle = true;
  OrganSettings settings;
  // Vessels, with which the organ bleeds: "" for none, kBuiltInVessels, or the name of a file of
  // vessels (io/vessels_file.h). The coordinates in such a file are the coordinates of the organ's
  // file, in mm.
  std::string vessels;
  // `landmarks` and `labels` are added to those of a particle file. Where the regions of labels
  // overlap, the last label counts.
  std::vector<Landmark> landmarks;
  std::vector<OrganLabel> labels;
  std::vector<OrganWound> wounds;
  // Not kept in recordings, which hold the resulting cells and vessels.
  std::vector<BroughtStructure> structures;
  bool smallVessels = true;  // smaller vessels are grown from the vessels in `structures`
  // Sentences for people about how these values were chosen. Not kept in recordings.
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

// kBuiltInOrgans: the organs that come with Resect. isBuiltIn(): whether the source is one of them.
inline constexpr std::string_view kBuiltInOrgans[] = {"liver", "gallbladder"};
inline bool isBuiltIn(const OrganSource& source) {
  return std::ranges::find(kBuiltInOrgans, source.file) != std::end(kBuiltInOrgans);
}
// isVesselsFile(): whether the source's vessels come from a file. hasVessels(): whether the source
// is a built-in organ that comes with vessels. organsWithVessels(): the names of such organs, for
// messages.
inline constexpr std::string_view kBuiltInVessels = "built-in";
inline bool isVesselsFile(const OrganSource& source) {
  return !source.vessels.empty() && source.vessels != kBuiltInVessels;
}
inline bool hasVessels(const OrganSource& source) { return source.file == "liver"; }
inline std::string organsWithVessels() { return "liver"; }
std::string builtInOrgans();  // "liver, gallbladder", for messages

// Pose, squeeze and pedal of a tool at one time. Between two keys, rotations are interpolated along
// the shorter great circle, and the other values linearly.
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

// How instruments act. Thesis: as in the diploma thesis that Resect continues: tissue is still,
// each instrument removes what it touches, and only one instrument is in hand at a time. Operation:
// each instrument acts by its working parts, such as edges and jaws.
enum class OperationMode { Thesis, Operation };

struct ScenarioTool {
  // Path of a description file (.toml), or name of a tool that comes with Resect.
  std::string model;
  // If given, replaces the response in the description file (ToolModel::response). "": the tool's
  // working parts act. "remove": the tool removes every particle that it touches.
  std::optional<std::string> response;
  Pose rest;  // its pose while it is not in hand, world
  // The keys in ascending order of time. The tool is in hand from the first key to the last one.
  std::vector<ToolKey> keys;
  // If given, the keys are made from this way when the organs are loaded
  // (operation/way/place_ways.h). Not kept in recordings, which hold the keys.
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
  bool elastic = false;                     // false: the tissue does not move, as in the thesis
  TissueMaterial material = liverTissue();  // of label 0, and of labels not in `materials`
  TissueSettings settings;
  std::vector<TissueAttachment> attachments;
  std::vector<LabelMaterial> materials;  // at most one per label
  // A sentence for people about each outdated entry in the scenario file. Not kept in recordings.
  std::vector<std::string> notes;

  // The material of the cells with a label.
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

// Springs that hold two organs together. Each spring leads from a particle of the first organ to
// the nearest particle of the second organ.
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
  std::string file;         // path of the file that it was read from; "": none
  std::string title;        // one line for people
  std::string description;  // what the scenario shows, for people
  // What must happen in a run for the title to be true: words of kPromises (operation/promises.h).
  // Not kept in recordings.
  std::vector<std::string> promises = {};
  OperationMode mode = OperationMode::Thesis;
  std::vector<ScenarioOrgan> organs = std::vector<ScenarioOrgan>(1);  // at least one
  std::vector<OrganJoint> joints;  // joints act on moving tissue only
  std::vector<ScenarioTool> tools;
  double frameRate = 60;  // frames per simulated second, 1 to 1000
  double duration = 1;    // simulated time of a run, s
  // s: if given, the run ends this long after the last key of any tool; see endAfterKeys().
  std::optional<double> after = {};  // not kept in recordings
  Breathing breathing;
  bool table = true, toolBox = true;  // whether the room has a table, and a tool box
  // The surroundings of the organs: "table", or "field" for an opened abdomen. They are drawn,
  // and elastic tissue cannot enter them (io/surroundings/surroundings_of.h). A recording keeps the
  // setting as text.
  std::string setting = "table";
  std::string view = "surgeon";  // name of the camera's view (docs/scenarios.md)
  std::optional<Aabb> closeUp;   // box that fills the pictures, world, m; none: organs fill them
  // The task, if any. A recording keeps the task as text (RecordingFile::task()), so visit() leaves
  // it out.
  std::optional<Task> task;

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("title", title), v("description", description), v("mode", mode);
    v("organs", organs), v("joints", joints), v("tools", tools), v("frameRate", frameRate);
    v("duration", duration), v("table", table), v("toolBox", toolBox), v("view", view);
    v("closeUp", closeUp), v("breathing", breathing);
  }
};

// Each of these functions throws Error if a number is out of its range (setting_ranges.h) or if a
// name of an organ is unknown. The functions are for scenarios that a program has made. The reader
// of scenario files (io/scenario/scenario_file.h) makes the same checks itself.
void requireSound(const OrganSource& source);
void requireSound(const TissueSetup& tissue);
void requireSound(const Scenario& scenario);

// Sets the depth of breathing, m. Throws Error if the depth is out of range, or if the
// depth is above 0 and no tissue moves.
void setBreathing(Scenario& scenario, double depth);
// Adds the usual breathing to a scenario that has moving tissue but no breathing. The breathing is
// off until FrameInput::breathes starts it.
void offerBreathing(Scenario& scenario);
// Whether any tissue moves.
bool moves(const Scenario& scenario);
// kSettingNames: the values of Scenario::setting, for messages. isSetting(): whether a word is one
// of these values.
constexpr const char* kSettingNames = "table or field";
bool isSetting(std::string_view name);
// Whether pictures show the opened abdomen. In thesis mode they always show the table.
bool showsField(const Scenario& scenario);
// The name of the tool's description file without folder and extension, such as "scalpel" for
// "tools/scalpel.toml". Tasks use these names for instruments.
std::string modelOf(const ScenarioTool& tool);
// Removes all organs except the first, and all joints.
void keepFirstOrgan(Scenario& scenario);
// Replaces all organs by one. The new organ gets the name and the tissue of the first organ. If
// source.onTable, it also gets the first organ's position. It does not get the materials of labels.
// Of the first organ's attachments, it gets those whose regions are given in fractions of the
// organ's box. If the new organ comes from another file than the first organ, the scenario changes:
// its title becomes the name of that file (base/text/file_stem.h), its setting becomes "table", and
// its description and close-up are removed.
void replaceOrgans(Scenario& scenario, const OrganSource& source);
// Sets the spacing of the first organ, m, and removes its dims. Scales the spacings of the other
// organs in proportion; an organ with dims keeps its dims. before: the first organ's spacing until
// now, m.
void setSpacing(Scenario& scenario, double before, double spacing);
// If Scenario::after is given, sets the duration to the time of the last key plus `after`, rounded
// up to a tenth of a second.
void endAfterKeys(Scenario& scenario);
// Makes the tissue of all organs elastic, and sets operation mode.
void makeElastic(Scenario& scenario);
// Makes the tissue of all organs still, and sets operation mode.
void makeStill(Scenario& scenario);
// Makes the tissue of all organs still, and sets thesis mode.
void makeThesis(Scenario& scenario);

// Pose, squeeze and pedal of a tool at `time`, s, and whether it is in hand then.
ToolInput toolInputAt(const ScenarioTool& tool, double time);

// Input of the frame with number `frame`, counted from 0. The frame ends at (frame + 1) /
// frameRate, s. In thesis mode at most one tool is in hand: the first tool whose keys say that it
// is in hand at the frame's end.
FrameInput frameInput(const Scenario& scenario, std::int64_t frame);
// Number of frames, at least 1.
std::int64_t frameCount(const Scenario& scenario);

}  // namespace resect

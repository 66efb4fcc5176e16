// A scenario: set-up and motions of an operation that is run from a file. Plain data;
// io/scenario/scenario_file.h reads it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "simulation/simulation.h"
#include "tissue/elastic/elastic_tissue.h"

namespace resect {

// Cells of the organ that belong to a structure of their own.
struct OrganLabel {
  int label = 1;     // 1 to 255
  std::string name;  // may be empty
  Region region;

  template <class Visitor>
  void visit(Visitor& v) {
    v("label", label), v("name", name), v("region", region);
  }
};

// Source of an organ and size of its cells.
struct OrganSource {
  std::string name = "organ";     // its name in the scenario
  std::string beside;             // organ whose pose it takes instead of one of its own; or ""
  std::string file = "liver";     // a built-in organ (isBuiltIn), or a file: model or particles
  std::string part;               // named part of the file, or "" for all
  double unit = 1;                // metres per unit of the file
  bool repair = false;            // close the holes of an open mesh instead of refusing it
  std::optional<double> spacing;  // cell side, m; either this or dims
  std::optional<Vec3i> dims;      // samples per axis of the thesis's grid over the bounding box
  bool resample = false;          // use spacing or dims even for a file that has cells of its own
  Pose pose;            // rotates the organ before it is laid on the table and moves it afterwards
  bool onTable = true;  // moved so that it stands centred on the table top, y = 0
  bool settle = true;   // if onTable: rolled to the nearest pose in which it lies still
  OrganSettings settings;
  std::vector<Landmark> landmarks;  // in addition to those of a file of cells
  std::vector<OrganLabel>
      labels;  // in addition to those of a file of cells; where they overlap the last counts

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("beside", beside), v("file", file), v("part", part), v("unit", unit);
    v("repair", repair), v("spacing", spacing), v("dims", dims), v("resample", resample);
    v("pose", pose), v("onTable", onTable), v("settle", settle), v("settings", settings);
    v("landmarks", landmarks), v("labels", labels);
  }
};

// Whether the source is one of the built-in organs, "liver" and "gallbladder".
inline bool isBuiltIn(const OrganSource& source) {
  return source.file == "liver" || source.file == "gallbladder";
}

// Pose of a tool at a time; between keys positions are interpolated linearly, rotations along the
// shorter great circle.
struct ToolKey {
  double time = 0;     // s from the start
  Pose pose;           // of the tool's frame, whose origin is the tip; world
  double squeeze = 0;  // of its jaws: 0 wide open, 1 closed
  double pedal = 0;    // of an energy device, 0 to 1

  template <class Visitor>
  void visit(Visitor& v) {
    v("time", time), v("pose", pose), v("squeeze", squeeze), v("pedal", pedal);
  }
};

// How instruments act. Thesis: tissue is still, each instrument removes what it touches, and only
// one is in hand at a time. Operation: each instrument acts by its working parts.
enum class OperationMode { Thesis, Operation };

struct ScenarioTool {
  std::string model;                    // the tool's description file (.toml)
  std::optional<std::string> response;  // replaces the tool's own: "remove", or "": its parts act
  Pose rest;                            // where it lies while not in hand
  std::vector<ToolKey>
      keys;  // ascending times; in hand from the first key's time to the last one's

  template <class Visitor>
  void visit(Visitor& v) {
    v("model", model), v("response", response), v("rest", rest), v("keys", keys);
  }
};

// The material of a label.
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
  bool elastic = false;     // false: it does not move, as in the original system
  TissueMaterial material;  // of label 0, and of labels without a material of their own
  TissueSettings settings;
  std::vector<TissueAttachment> attachments;
  std::vector<LabelMaterial> materials;  // at most one per label

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

// Springs that hold two organs together: from each particle of the first to the nearest of the
// second.
struct OrganJoint {
  std::string organs[2];
  double reach = 0.01;      // m: particles farther apart at rest are not joined
  double stiffness = 1000;  // of all springs together, N/m

  template <class Visitor>
  void visit(Visitor& v) {
    v("first", organs[0]), v("second", organs[1]), v("reach", reach), v("stiffness", stiffness);
  }
};

struct Scenario {
  std::string name;         // the file's name without extension
  std::string title;        // one line for people
  std::string description;  // what it shows
  OperationMode mode = OperationMode::Thesis;
  std::vector<ScenarioOrgan> organs = std::vector<ScenarioOrgan>(1);  // at least one
  std::vector<OrganJoint> joints;  // of tissue that moves; still tissue needs none
  std::vector<ScenarioTool> tools;
  double frameRate = 60;              // frames per simulated second, 1 to 1000
  double duration = 1;                // s
  bool table = true, toolBox = true;  // what stands in the room
  std::string view = "surgeon";       // camera
  std::optional<Aabb> closeUp;        // box that pictures show, world, m; without it the organ

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("title", title), v("description", description), v("mode", mode);
    v("organs", organs), v("joints", joints), v("tools", tools), v("frameRate", frameRate);
    v("duration", duration), v("table", table), v("toolBox", toolBox), v("view", view);
    v("closeUp", closeUp);
  }
};

// Throw Error for values that cannot be run, such as a time or stiffness out of range or an organ's
// name that is not known. For scenarios made by programs; io/scenario/scenario_file.h checks more
// in a file. Spacings, refinement, iso level and materials are checked where they are used.
void requireSound(const OrganSource& source);
void requireSound(const TissueSetup& tissue);
void requireSound(const Scenario& scenario);

// Whether any tissue moves.
bool moves(const Scenario& scenario);
// Removes all organs but the first.
void keepFirstOrgan(Scenario& scenario);
// Sets the first organ's spacing, m, and scales the spacings of the others in proportion. before:
// the first organ's spacing until now, m. Others that are given by dims keep their dims.
void setSpacing(Scenario& scenario, double before, double spacing);
// Makes the tissue of all organs elastic and instruments act by their working parts.
void makeElastic(Scenario& scenario);
// Sets thesis mode: tissue is still, instruments remove what they touch, one at a time.
void makeThesis(Scenario& scenario);

// Input for a scenario's tool at a time, s: pose, squeeze and pedal, and whether it is in hand.
ToolInput toolInputAt(const ScenarioTool& tool, double time);

// Input of frame number `frame` (from 0), which ends at (frame + 1) / frameRate, s. In thesis mode
// only the first of several tools in hand counts as in hand.
FrameInput frameInput(const Scenario& scenario, std::int64_t frame);
std::int64_t frameCount(const Scenario& scenario);

}  // namespace resect

// What is set up and what happens in an operation that is run from a file? Plain data;
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
};

// Where the organ comes from and how finely it is taken.
struct OrganSource {
  std::string name = "organ";     // how others in the scenario name it
  std::string beside;             // laid as the organ of that name is, not by itself; or ""
  std::string file;               // model or discretisation file; or see isBuiltIn
  std::string part;               // named part of the file, or "" for all
  double unit = 1;                // metres per unit of the file
  bool repair = false;            // close the holes of an open mesh instead of refusing it
  std::optional<double> spacing;  // cell side, m; or
  std::optional<Vec3i> dims;      // the thesis's grid over the bounding box
  bool resample = false;          // so too where the file is a discretisation with cells of its own
  Pose pose;  // turns the organ before it is laid on the table; the position is added after
  bool onTable = true;  // moved so that it stands centred on the table top, y = 0
  bool settle = true;   // on the table, rolled to the nearest pose in which it lies still
  OrganSettings settings;
  std::vector<Landmark> landmarks;  // besides those of a file of cells
  std::vector<OrganLabel> labels;  // besides those of a file of cells; where they meet the last one
};

// Resect's own models: "" is the liver, "gallbladder" the gallbladder.
inline bool isBuiltIn(const OrganSource& source) {
  return source.file.empty() || source.file == "gallbladder";
}

// As people name an organ: "liver", "gallbladder" or a file.
inline std::string organFile(const std::string& name) { return name == "liver" ? "" : name; }

// A tool is here at this time; between keys it moves linearly and turns along the shorter great
// circle.
struct ToolKey {
  double time;         // s from the start
  Pose pose;           // of the tool's frame: tip at the position
  double squeeze = 0;  // of its jaws: 0 wide open, 1 closed
  double pedal = 0;    // of an energy device, 0 to 1
};

// How instruments act. Thesis: tissue is still, each takes out what it touches, and one is held at
// a time. Operation: by their working parts.
enum class OperationMode { Thesis, Operation };

struct ScenarioTool {
  std::string model;                    // the tool's description file (.toml)
  std::optional<std::string> response;  // instead of the tool's own: "remove", or "" for its kind's
  Pose rest;                            // where it lies while not in hand
  std::vector<ToolKey>
      keys;  // ascending times; in hand from the first key's time to the last one's
};

// What cells of a label are of.
struct LabelMaterial {
  int label = 1;  // 1 to 255
  TissueMaterial material;
};

// How the organ's tissue moves.
struct TissueSetup {
  bool elastic = false;     // false: it does not move, as in the original system
  TissueMaterial material;  // of the organ's own cells, and of labels that have none
  TissueSettings settings;
  std::vector<TissueAttachment> attachments;
  std::vector<LabelMaterial> materials;  // a label once

  const TissueMaterial& materialOf(int label) const {
    for (const LabelMaterial& one : materials)
      if (one.label == label) return one.material;
    return material;
  }
};

struct ScenarioOrgan {
  OrganSource source;
  TissueSetup tissue;
};

// Springs that hold two organs together: from each particle of the first to the nearest of the
// second.
struct OrganJoint {
  std::string organs[2];
  double reach = 0.01;      // m: particles farther apart at rest are not joined
  double stiffness = 1000;  // of all springs together, N/m
};

struct Scenario {
  std::string name;         // as in the file's name
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
  std::optional<Aabb> closeUp;        // what pictures show, room space; without it the organ
};

// Whether any tissue moves.
bool moves(const Scenario& scenario);
// Without the organs beside the first one.
void keepFirstOrgan(Scenario& scenario);
// The first organ in cells of this size, m; the others' cells grow or shrink in proportion to what
// the first one's were before. Others that are given by dims keep theirs.
void setSpacing(Scenario& scenario, double before, double spacing);
// The tissue of all organs moves, and instruments act by their working parts.
void makeElastic(Scenario& scenario);
// The same operation as the original system would have it: tissue is still, instruments take out
// what they touch, one at a time.
void makeThesis(Scenario& scenario);

// Where a scenario's tool is, and whether it is in hand, at a time.
ToolInput toolInputAt(const ScenarioTool& tool, double time);

// Input of frame number `frame` (from 0), which ends at (frame + 1) / frameRate. In thesis mode the
// first tool that is in hand is the only one.
FrameInput frameInput(const Scenario& scenario, std::int64_t frame);
std::int64_t frameCount(const Scenario& scenario);

}  // namespace resect

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
};

// Source of an organ and size of its cells.
struct OrganSource {
  std::string name = "organ";     // its name in the scenario
  std::string beside;             // placed like the organ of that name, not by itself; or ""
  std::string file = "liver";     // a built-in organ (isBuiltIn), or a model or discretisation file
  std::string part;               // named part of the file, or "" for all
  double unit = 1;                // metres per unit of the file
  bool repair = false;            // close the holes of an open mesh instead of refusing it
  std::optional<double> spacing;  // cell side, m; or
  std::optional<Vec3i> dims;      // the thesis's grid over the bounding box
  bool resample = false;  // applies spacing or dims also to a file that has cells of its own
  Pose pose;  // rotation applied before it is laid on the table; position added afterwards
  bool onTable = true;  // moved so that it stands centred on the table top, y = 0
  bool settle = true;   // on the table, rolled to the nearest pose in which it lies still
  OrganSettings settings;
  std::vector<Landmark> landmarks;  // besides those of a file of cells
  std::vector<OrganLabel>
      labels;  // besides those of a file of cells; where they overlap the last one holds
};

// Whether it is a built-in model: "" is the liver, "gallbladder" the gallbladder.
inline bool isBuiltIn(const OrganSource& source) {
  return source.file == "liver" || source.file == "gallbladder";
}

// Pose of a tool at a time; between keys positions are interpolated linearly, rotations along the
// shorter great circle.
struct ToolKey {
  double time;         // s from the start
  Pose pose;           // of the tool's frame: tip at the position
  double squeeze = 0;  // of its jaws: 0 wide open, 1 closed
  double pedal = 0;    // of an energy device, 0 to 1
};

// How instruments act. Thesis: tissue is still, each instrument removes what it touches, one is in
// hand at a time. Operation: by their working parts.
enum class OperationMode { Thesis, Operation };

struct ScenarioTool {
  std::string model;                    // the tool's description file (.toml)
  std::optional<std::string> response;  // instead of the tool's own: "remove", or "" for its kind's
  Pose rest;                            // where it lies while not in hand
  std::vector<ToolKey>
      keys;  // ascending times; in hand from the first key's time to the last one's
};

// The material of a label.
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
  std::optional<Aabb> closeUp;        // region shown in pictures, world; without it the organ
};

// Throw Error unless all numbers are in their ranges and all names of organs known: what
// io/scenario/scenario_file.h checks in a file, for scenarios made by programs.
void requireSound(const OrganSource& source);
void requireSound(const TissueSetup& tissue);
void requireSound(const Scenario& scenario);

// Whether any tissue moves.
bool moves(const Scenario& scenario);
// Removes all organs but the first.
void keepFirstOrgan(Scenario& scenario);
// Sets the first organ's spacing, m, and scales the others' in proportion; before: the first one's
// spacing so far. Others that are given by dims keep theirs.
void setSpacing(Scenario& scenario, double before, double spacing);
// Makes the tissue of all organs elastic and instruments act by their working parts.
void makeElastic(Scenario& scenario);
// Sets thesis mode: tissue is still, instruments remove what they touch, one at a time.
void makeThesis(Scenario& scenario);

// Pose of a scenario's tool at a time, and whether it is in hand.
ToolInput toolInputAt(const ScenarioTool& tool, double time);

// Input of frame number `frame` (from 0), which ends at (frame + 1) / frameRate. In thesis mode
// only the first tool in hand counts.
FrameInput frameInput(const Scenario& scenario, std::int64_t frame);
std::int64_t frameCount(const Scenario& scenario);

}  // namespace resect

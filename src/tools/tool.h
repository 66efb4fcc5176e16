// An instrument: a shape, and a list of working parts that act on tissue.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "tools/finish.h"
#include "tools/working_part.h"

namespace resect {

// Two blades that rotate relative to each other about a pivot. Coordinates are in the tool's frame.
struct Jaws {
  Vec3 pivot = Vec3::Zero();  // m
  Vec3 axis = Vec3::UnitX();  // unit
  double opening = 0;         // angle between the wide open blades, rad; 0: no jaws

  template <class Visitor>
  void visit(Visitor& v) {
    v("pivot", pivot), v("axis", axis), v("opening", opening);
  }
};

// A piece of an instrument as viewers draw it, in the tool's frame, with the jaws closed.
struct DrawnPart {
  TriangleMesh mesh;
  std::vector<Vec3f> normals{};    // unit, one per point; empty: viewers compute them
  std::optional<Finish> finish{};  // none: steel
  // Whether the mesh is closed and oriented outwards, so that its back faces are never seen.
  bool closed = false;
  // Angle by which the part is turned when the jaws are wide open, about the jaws' pivot and axis,
  // rad; 0 for a part that is not a jaw.
  double opens = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("mesh", mesh), v("normals", normals), v("finish", finish), v("closed", closed);
    v("opens", opens);
  }
};

// An instrument's shape and working parts. Coordinates are in the tool's frame, m. By default the
// tip is at the origin and the handle is on the +Z axis.
struct ToolModel {
  std::string name;                // shown to people
  std::string kind;                // chooses its working parts: see tools/registry.h
  std::vector<std::string> parts;  // names of its working parts; empty: the parts of its kind
  std::string description;         // one sentence for people
  std::filesystem::path file;      // the model's file, for messages
  TriangleMesh mesh;               // closed, oriented outwards
  Vec3 tip = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  // unit, from tip to handle
  // Cutting edge, from the tip to the edge's end near the handle. For a tool with jaws: the line in
  // which the edges of both jaws lie when the jaws are closed. Empty for a blunt tool.
  std::vector<Vec3> edge;
  Jaws jaws;                     // `mesh` shows them wide open
  std::vector<DrawnPart> drawn;  // for viewers; empty: viewers draw `mesh`
  std::vector<Vec3> hook;        // centre line of a hook's bend; empty: the tool has no hook
  Vec3 point = Vec3::Zero();     // end of the hook
  double contactRadius = 0;      // radius of a round tip; 0: the tool has none
  // Empty: the tool's working parts act. "remove": the tool removes what it touches, as all
  // instruments did in the diploma thesis that Resect continues.
  std::string response;
  double friction = 0.3;  // Coulomb's coefficient, on tissue
  // Energy that a cut with the tool's edges takes, divided by the energy that a cut with a new
  // blade takes; 0 or more.
  double bluntness = 1;
  double slipForce = 6.0;  // force at which gripped cells are released, N; 0: never
};

struct Tool {
  ToolModel model;
  Aabb bounds;  // of the mesh, in the tool's frame
  // The parts act one after the other. Empty: the instrument only pushes with its shape.
  std::vector<std::unique_ptr<WorkingPart>> parts;
};

}  // namespace resect

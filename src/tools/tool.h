// An instrument: a shape, and a list of working parts that act on tissue.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "tools/working_part.h"

namespace resect {

// Two blades that rotate against each other about a pivot, in the tool's frame.
struct Jaws {
  Vec3 pivot = Vec3::Zero();  // m
  Vec3 axis = Vec3::UnitX();  // unit
  double opening = 0;         // angle of the edges when wide open, rad; 0: the tool has no jaws

  template <class Visitor>
  void visit(Visitor& v) {
    v("pivot", pivot), v("axis", axis), v("opening", opening);
  }
};

// An instrument's shape and working parts, in its own frame: tip at the origin, handle along +Z.
// All lengths in m.
struct ToolModel {
  std::string name;                // shown to people
  std::string kind;                // chooses its working parts: see tools/registry.h
  std::vector<std::string> parts;  // working parts to have instead; empty: those of its kind
  std::string description;         // one sentence
  std::filesystem::path file;      // the model's file, for viewers
  TriangleMesh mesh;               // closed, outwards
  Vec3 tip = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  // unit, tip to handle
  // Cutting edge from tip to heel; with jaws, where both edges lie when closed. Empty for a blunt
  // tool.
  std::vector<Vec3> edge;
  Jaws jaws;                  // the mesh shows them wide open
  std::vector<Vec3> hook;     // centre line of a hook's bend; empty: the tool has no hook
  Vec3 point = Vec3::Zero();  // end of the hook
  double contactRadius = 0;   // radius of a round tip; 0: the tool has none
  // "": the tool's working parts act. "remove": the tool removes what it touches, as all
  // instruments of the thesis did.
  std::string response;
  double friction = 0.3;   // Coulomb's coefficient, on tissue
  double slipForce = 6.0;  // N: a hook releases its cells beyond it; 0: never
};

struct Tool {
  ToolModel model;
  Aabb bounds;  // of the mesh, in the tool's frame
  // The parts act one after the other. Empty: the instrument only pushes with its shape.
  std::vector<std::unique_ptr<WorkingPart>> parts;
};

}  // namespace resect

// What does an instrument do when it touches tissue? One class per response; the rest is plain
// data.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "collision/swept_blade.h"
#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"
#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Two blades that turn against each other about a pivot, in the tool's frame.
struct Jaws {
  Vec3 pivot = Vec3::Zero();  // m
  Vec3 axis = Vec3::UnitX();  // unit
  double opening = 0;         // between the edges when wide open, rad; 0: the tool has no jaws
};

// An instrument's shape and working parts, in its own frame: tip at the origin, handle along +Z.
// All lengths in m.
struct ToolModel {
  std::string name;            // shown to people
  std::string kind;            // chooses the response: see tools/registry.h
  std::string description;     // one sentence
  std::filesystem::path file;  // the model's file, for viewers
  TriangleMesh mesh;           // closed, outwards
  Vec3 tip = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  // unit, tip to handle
  std::vector<Vec3> edge;     // cutting edge, tip to heel; empty for a blunt tool; of jaws: closed
  Jaws jaws;                  // the mesh shows them wide open
  std::vector<Vec3> hook;     // centre line of a hook's bend; empty without one
  Vec3 point = Vec3::Zero();  // end of the hook
  double contactRadius = 0;   // of a round tip; 0 when the tool has none
  // What it does to tissue that moves: "" its own, or "remove": takes out what it touches, as all
  // tools do to tissue that does not move.
  std::string response;
  double friction = 0.3;   // Coulomb's, on tissue
  double slipForce = 6.0;  // N: a hook lets go beyond it
};

// What one tool touches in one step.
struct ToolContacts {
  std::int32_t tool = -1;           // index of the tool in the simulation
  std::vector<std::int64_t> cells;  // particles inside the volume that the tool swept, ascending
  bool tissueMoves = false;         // the following are filled for tissue that moves
  SweptBlade blade;                 // what its edge swept while it cut; empty when it did not
  std::vector<std::int64_t> nearBlade;  // particles near that, ascending
  std::vector<TissueBond> crossed;      // bonds that its edge has passed through, ascending
  std::vector<std::int64_t> caught;     // particles in its bend while it pulls, ascending
  bool pulls = false;                   // it moves towards its handle
  std::int32_t gripped = 0;             // particles that it holds
  double overlapVolume = 0;  // m^3 of organ and tool in the same place at the end of the step
  Aabb volumeOfInterest;     // where both boxes overlap; empty when they do not
};

class Tool {
 public:
  explicit Tool(ToolModel model) : model_(std::move(model)), bounds_(resect::bounds(model_.mesh)) {}
  virtual ~Tool() = default;

  const ToolModel& model() const { return model_; }
  bool removes(const ToolContacts& contacts) const {
    return !contacts.tissueMoves || model_.response == "remove";
  }
  const Aabb& bounds() const { return bounds_; }  // of the mesh, in the tool's frame

  // Queues what the tool does to the tissue that it touches. Never touches the organ itself.
  virtual void act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const = 0;

 private:
  ToolModel model_;
  Aabb bounds_;
};

}  // namespace resect

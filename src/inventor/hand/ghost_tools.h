// The instruments of a scenario's own motions, drawn as ghosts: what a good operator does, beside
// what the hand does.
#pragma once

#include <span>
#include <vector>

#include "operation/scenario.h"
#include "tools/tool.h"

class SoSeparator;
class SoSwitch;
class SoTransform;

namespace resect {

class GhostTools {
 public:
  // models: one per tool of the scenario.
  GhostTools(SoSeparator* parent, const Scenario& scenario, std::span<const ToolModel> models);
  ~GhostTools();
  GhostTools(const GhostTools&) = delete;
  GhostTools& operator=(const GhostTools&) = delete;

  bool any() const { return !ghosts_.empty(); }  // the scenario has motions
  // The moment of the motions, s from their start; they begin again when they are over. Returns the
  // box, world, m, of what has to be drawn again: empty if nothing changed visibly.
  Aabb show(double time);
  Aabb hide();

 private:
  struct Ghost {
    std::size_t tool;
    Aabb bounds;  // of its mesh, in its own frame, m
    SoSwitch* shown;
    SoTransform* place;
    Pose pose;
  };
  const Scenario& scenario_;
  SoSeparator* parent_;
  SoSwitch* root_;
  std::vector<Ghost> ghosts_;
  double begin_ = 0, end_ = 0;  // s: of the motions
  Aabb box_;                    // of what is shown
};

}  // namespace resect

// Ghosts are transparent copies of the instruments. The ghosts follow the motions that the scenario
// gives its instruments. So the ghosts show the user what a good operator does.
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
  // models: one model for each tool of the scenario.
  GhostTools(SoSeparator* parent, const Scenario& scenario, std::span<const ToolModel> models);
  ~GhostTools();
  GhostTools(const GhostTools&) = delete;
  GhostTools& operator=(const GhostTools&) = delete;

  bool any() const { return !ghosts_.empty(); }  // whether the scenario contains motions
  // show() shows the ghosts at their poses for a given time. time: seconds since the start of the
  // motions. When the motions end, they start again. hide() hides the ghosts. Both functions return
  // the box that must be drawn again; world, m. The box is empty if nothing has changed visibly.
  Aabb show(double time);
  Aabb hide();

 private:
  struct Ghost {
    std::size_t tool;
    Aabb bounds;  // bounds of the tool's mesh, in the tool's frame, m
    SoSwitch* shown;
    SoTransform* place;
    Pose pose;
  };
  const Scenario& scenario_;
  SoSeparator* parent_;
  SoSwitch* root_;
  std::vector<Ghost> ghosts_;
  double begin_ = 0, end_ = 0;  // start and end of the motions, s
  Aabb box_;                    // bounds of the ghosts as shown now, world, m
};

}  // namespace resect

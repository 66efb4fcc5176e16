// Shows an operation: the operating room with the organs and tools of a scenario.
#pragma once

#include <string>

#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operating_room.h"
#include "inventor/scene/room_models.h"
#include "operation/adnexa/adnexa.h"
#include "operation/live/surface_publisher.h"
#include "operation/scenario.h"
#include "operation/smoke/smoke_plume.h"
#include "simulation/simulation.h"
#include "surface/surface_update.h"

namespace resect {

// Screen colour (sRGB) of an organ before any cut.
Vec3f organColour(const OrganSource& organ);

class OperationView {
 public:
  // Sets up room, tools and organs, and calls simulation.keepLook(), so that each step updates
  // normals for pictures. Aims the lamps at the organs. Aims the camera at the box scenario.closeUp
  // if it is set, otherwise at the organs. aspect: width / height of the picture. If no view has
  // the name scenario.view (roomView()), throws an Error that lists the views.
  OperationView(const Scenario& scenario, Simulation& simulation, double aspect);

  // Call this after every step. It moves the tools, applies the changes of all organs' surfaces,
  // and shows blood and bare vessels as they are now.
  void follow(const Simulation& simulation);
  // Call this after every step, too. It shows the smoke of this step and of earlier steps. In
  // thesis mode, in which instruments only remove tissue, there is no smoke.
  void followSmoke(const StepReport& step);
  // For an operation that runs in another thread. Applies the changes of the organs' surfaces, and
  // does nothing else. updates: one update per organ.
  void follow(std::span<const SurfaceUpdate> updates);

  RgbImage draw(OffscreenView& picture) const;

  // field = true: shows the operative field (the opened abdomen) round the organs. In the field,
  // tools are hidden while they are at their rest poses: unused instruments lie on a stand outside
  // the picture. field = false: shows the table and the tool box, if the scenario has them.
  void showField(bool field);

  OperatingRoom& room() { return room_; }

 private:
  OperatingRoom room_;
  std::vector<double> bloody_;  // for each tool: length that blood covers, from the tip on, m
  Aabb organs_;                 // box of the organs at rest; world, m
  std::vector<Pose> rests_;     // rest poses of the tools
  bool smokes_;                 // whether smoke is shown
  SmokePlume smoke_;
  double smokeTime_ = 0;  // simulated time of smoke_, s
  bool table_, toolBox_;  // whether the scenario has a table and a tool box
  Adnexa adnexa_;
  // One publisher per organ of the simulation. It publishes even the smallest motion of the organ's
  // surface.
  std::vector<SurfacePublisher> publishers_;
};

}  // namespace resect

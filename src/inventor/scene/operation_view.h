// View of an operation: the operating room with a scenario's organs and tools.
#pragma once

#include <string>

#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operating_room.h"
#include "operation/live/surface_publisher.h"
#include "operation/scenario.h"
#include "simulation/simulation.h"
#include "surface/surface_update.h"

class SoNode;

namespace resect {

// Reads the model "table", "toolbox" or "field" from Resect's own data folder, and returns it as a
// scene graph with its materials. Coin reads no other files in this process. All other model files
// are read by readModel(), in a child process.
SoNode* readRoomModel(const std::string& name);

// Screen colour (sRGB) of an organ that has not been cut.
Vec3f organColour(const OrganSource& organ);

class OperationView {
 public:
  // Sets up room, tools and organs. Aims the lamps at the organs. Aims the camera at
  // scenario.closeUp if that is set, otherwise at the organs. `aspect`: width / height of the
  // picture. Calls simulation.keepLook(). If there is no view named scenario.view (roomView()),
  // throws an Error that lists the views.
  OperationView(const Scenario& scenario, Simulation& simulation, double aspect);

  // Call after every step. Moves the tools and applies the changes of all organs' surfaces.
  void follow(const Simulation& simulation);
  // For an operation that runs in another thread. Applies the changes of the organs' surfaces, one
  // update per organ; moves no tools.
  void follow(std::span<const SurfaceUpdate> updates);

  RgbImage draw(OffscreenView& picture) const;

  // Shows the operative field round the organs, or table and tool box if the scenario has them. In
  // the field, tools are hidden while they are at rest: they lie on a stand beside the patient.
  void showField(bool field);

  OperatingRoom& room() { return room_; }

 private:
  OperatingRoom room_;
  std::vector<double> bloody_;  // per tool: distance from its tip that blood covers, m
  Aabb organs_;                 // box of the organs at rest, world, m
  std::vector<Pose> rests_;
  bool table_, toolBox_;  // whether the scenario has them
  // One per organ of the simulation. These publishers publish every motion, however small.
  std::vector<SurfacePublisher> publishers_;
};

}  // namespace resect

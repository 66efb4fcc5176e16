// What does an operation look like at this moment? The operating room with the scenario's organ and
// tools in it.
#pragma once

#include <filesystem>
#include <string>

#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operating_room.h"
#include "operation/live/surface_publisher.h"
#include "operation/scenario.h"
#include "simulation/simulation.h"
#include "surface/surface_update.h"

class SoNode;

namespace resect {

// Reads one of the models that come with Resect as a scene graph, materials and all. Not for
// untrusted files: those go through readModel.
SoNode* readSceneFile(const std::filesystem::path& path);

class OperationView {
 public:
  // Sets up room, tools and organ, aims lamps at the organ and the camera at it or at
  // scenario.closeUp. `aspect` = width / height of the picture. The view named by scenario.view
  // must be one of roomView()'s; an Error lists them. From then on the simulation keeps its look.
  OperationView(const Scenario& scenario, Simulation& simulation, double aspect);

  // After every step: moves the tools and hands on what has changed of the surface, as it is now.
  void follow(const Simulation& simulation);
  // The same for an operation that goes on in another thread; the tools stay where they are.
  void follow(std::span<const SurfaceUpdate> updates);

  RgbImage draw(OffscreenView& picture) const;

  OperatingRoom& room() { return room_; }

 private:
  OperatingRoom room_;
  // Of the simulation that is followed, one per organ: all that moves is shown.
  std::vector<SurfacePublisher> publishers_;
};

}  // namespace resect

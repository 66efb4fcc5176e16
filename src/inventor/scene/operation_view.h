// View of an operation: the operating room with the scenario's organs and tools.
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
  // must be one of roomView()'s; an Error lists them. Calls keepLook() of the simulation.
  OperationView(const Scenario& scenario, Simulation& simulation, double aspect);

  // Call after every step: moves the tools and applies the surface's changes.
  void follow(const Simulation& simulation);
  // The same for an operation in another thread; tools are not moved.
  void follow(std::span<const SurfaceUpdate> updates);

  RgbImage draw(OffscreenView& picture) const;

  OperatingRoom& room() { return room_; }

 private:
  OperatingRoom room_;
  // One per organ of the simulation; no motion is left out.
  std::vector<SurfacePublisher> publishers_;
};

}  // namespace resect

// What is live while a person operates? The room, the instruments in hand, the camera, the iso
// scale and the operation behind them: all of a window but the window.
//
// Driven by Inventor events and by update(), so any toolkit, and any test, can drive it.
#pragma once

#include <Inventor/actions/SoHandleEventAction.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "inventor/gl/camera_moves.h"
#include "inventor/gl/damage.h"
#include "inventor/hand/iso_dragger.h"
#include "inventor/hand/six_axes.h"
#include "inventor/hand/tip_marker.h"
#include "inventor/hand/tool_handling.h"
#include "inventor/scene/operation_view.h"
#include "operation/live/live_operation.h"

class SbViewportRegion;
class SoEvent;

namespace resect {

class OperatingSession {
 public:
  // aspect: width / height of the picture. The tools lie in the tool box for a person to take.
  OperatingSession(const Scenario& scenario, std::unique_ptr<Simulation> simulation, double aspect);

  // An event of mouse or keyboard, positions in pixels of the viewport, from its lower left. True
  // when somebody took it.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);

  // Takes what the operation has changed since the last call and lets Inventor's sensors run.
  // Returns what has to be drawn again.
  Damage update();
  bool pending() const { return !damage_.empty(); }  // there is something to draw already

  // Goes on with the motions of the scenario, in its frames, until this time of theirs (s), or from
  // their start once they are over. A person who takes a tool ends it.
  void play(double until);
  bool playing() const { return playing_; }

  // Moves and turns the tool in hand; without one, all that is seen.
  void follow(const ViewMotion& motion);
  void look(RoomView view, double aspect);
  // Organ, tray and scale in the picture, from the side that they are looked at now.
  void viewAll(double aspect);
  // All of the organ and the tool box in sight, all tools in the tool box.
  void bringEverythingBack(double aspect);
  // The point under a pixel, of the organ as it is seen now or of the table's plane, within 5 m;
  // nothing there: false.
  bool pointUnder(const SbVec2s& pixel, const SbViewportRegion& viewport, Vec3& point) const;
  // Middle of a tool, for a pointer to click on: pixels of the viewport.
  SbVec2s pixelOf(const Vec3& point, const SbViewportRegion& viewport) const;
  Vec3 middleOfTool(int tool) const;

  SoNode* root() const { return view_.room().root(); }
  OperatingRoom& room() const { return view_.room(); }
  ToolHandling& tools() { return tools_; }
  CameraMoves& camera() { return camera_; }
  IsoDragger& iso() { return iso_; }
  LiveOperation& operation() { return operation_; }
  const LiveState& state() const { return state_; }
  const Scenario& scenario() const { return scenario_; }
  const std::vector<ToolModel>& toolModels() const { return toolModels_; }
  const Discretization& cells() const { return cells_; }  // as the operation began

 private:
  Aabb allThereIs() const;
  void toolsChanged();
  void followMotion();
  void stopPlaying();
  Vec3 lampPosition() const;

  Scenario scenario_;
  std::vector<ToolModel> toolModels_;
  Discretization cells_;
  Aabb organBox_;
  mutable OperationView view_;
  ToolHandling tools_;
  CameraMoves camera_;
  IsoDragger iso_;
  TipMarker marker_;
  SoHandleEventAction events_;
  Damage damage_{true, {}, {}};
  std::vector<Aabb> toolBoxes_;                 // as drawn last
  std::vector<std::vector<Aabb>> toolSlices_;   // along each tool's axis, in its frame
  std::vector<std::vector<Aabb>> shownSlices_;  // where they were drawn last
  Aabb markerBox_;
  bool playing_ = false;
  std::int64_t played_ = 0, playUntil_ = 0;  // frames of the scenario's motions
  LiveState state_;
  LiveOperation operation_;  // last: ends its thread before what it shows goes
};

}  // namespace resect

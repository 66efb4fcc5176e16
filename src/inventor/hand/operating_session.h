// An interactive operation without its window: the room, the instruments in hand, the camera, the
// iso scale and the live operation.
//
// Driven by Inventor events and update(), so any toolkit, or a test, can use it.
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
  // aspect: width / height of the picture. The tools start in the tool box.
  OperatingSession(const Scenario& scenario, std::unique_ptr<Simulation> simulation, double aspect);

  // An event of mouse or keyboard, positions in pixels of the viewport, from its lower left. True
  // if it was handled.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);

  // Takes the operation's changes since the last call and runs Inventor's sensors. Returns what has
  // to be drawn again.
  Damage update();
  bool pending() const { return !damage_.empty(); }  // there is damage to draw

  // Plays the scenario's motions, frame by frame, up to this scenario time, s; from their start if
  // they are over. Taking a tool stops it.
  void play(double until);
  bool playing() const { return playing_; }

  // Moves and turns the tool in hand; without one, the camera.
  void follow(const ViewMotion& motion);
  void look(RoomView view, double aspect);
  // Moves the camera so that organ, tool box and scale are in the picture, keeping its direction.
  void viewAll(double aspect);
  // Shows the whole organ and the tool box, with all tools in the tool box.
  void bringEverythingBack(double aspect);
  // The point under a pixel, on the organ's present surface or on the table's plane, within 5 m;
  // false if there is none.
  bool pointUnder(const SbVec2s& pixel, const SbViewportRegion& viewport, Vec3& point) const;
  // Position of a point in the viewport, pixels; and a point of a tool that can be clicked.
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
  const Discretization& cells() const { return cells_; }  // at the start of the operation

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
  std::vector<std::vector<Aabb>> shownSlices_;  // as drawn last, in the world
  Aabb markerBox_;
  bool playing_ = false;
  std::int64_t played_ = 0, playUntil_ = 0;  // frames of the scenario's motions
  LiveState state_;
  LiveOperation operation_;  // last member: its thread ends before the others are destroyed
};

}  // namespace resect

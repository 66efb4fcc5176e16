// An interactive operation without its window: the room, the instruments in hand, the camera, the
// iso scale and the live operation.
//
// Its only inputs are Inventor events and calls of its functions, so any toolkit, or a test, can
// use it.
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
  // `aspect`, here and below: width / height of the picture. The tools start in the tool box.
  OperatingSession(const Scenario& scenario, std::unique_ptr<Simulation> simulation, double aspect);

  // Handles an event of mouse or keyboard, with its position in pixels from the lower left of the
  // viewport. Returns whether anything used it.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);

  // Takes the operation's changes since the last call and runs Inventor's sensors. Returns the
  // damage since the last call.
  Damage update();
  bool pending() const { return !damage_.empty(); }  // there is damage to draw

  // Plays the scenario's motions, frame by frame, up to this scenario time, s. Begins where the
  // last call ended, or at their start if they are over or were stopped. Taking a tool stops them.
  void play(double until);
  bool playing() const { return playing_; }

  // Moves and turns the tool in hand; without one, the camera.
  void follow(const ViewMotion& motion);
  void look(RoomView view, double aspect);
  // Moves the camera so that organs, tool box and iso scale are in the picture; its direction
  // stays.
  void viewAll(double aspect);
  // Stops the motions, puts all tools back into the tool box and shows the surgeon's view, which
  // includes all organs and the tool box.
  void bringEverythingBack(double aspect);
  // Sets `point` to the point under a pixel, on an organ's present surface or on the table's plane
  // (world, m). False if there is none within 5 m.
  bool pointUnder(const SbVec2s& pixel, const SbViewportRegion& viewport, Vec3& point) const;
  // Position of a point in the viewport, pixels.
  SbVec2s pixelOf(const Vec3& point, const SbViewportRegion& viewport) const;
  // Middle of a tool's box, world, m: a click there takes the tool if nothing hides it.
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
  // Of the first organ, before the operation.
  const Discretization& cells() const { return cells_; }

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
  std::vector<Aabb> toolBoxes_;                 // of each tool as drawn last, world
  std::vector<std::vector<Aabb>> toolSlices_;   // boxes along each tool's axis, in its frame
  std::vector<std::vector<Aabb>> shownSlices_;  // the same as drawn last, world
  Aabb markerBox_;
  bool playing_ = false;
  std::int64_t played_ = 0, playUntil_ = 0;  // frame numbers in the scenario
  LiveState state_;
  LiveOperation operation_;  // last member: its thread ends before the others are destroyed
};

}  // namespace resect

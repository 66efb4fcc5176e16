// An interactive operation without its window: the operating room, the handling of instruments, the
// camera, the iso scale and the live operation.
//
// The only inputs are Inventor events and calls of the functions below. So any window toolkit, or a
// test, can use this class.
#pragma once

#include <Inventor/actions/SoHandleEventAction.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "inventor/gl/camera_moves.h"
#include "inventor/gl/damage.h"
#include "inventor/hand/ghost_tools.h"
#include "inventor/hand/iso_dragger.h"
#include "inventor/hand/marks/aim_marker.h"
#include "inventor/hand/marks/bleeding_marks.h"
#include "inventor/hand/marks/guide_marks.h"
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
  // The tools start at their rest poses. `aspect`, here and below: width / height of the picture.
  // watch, history, paused: as LiveOperation takes them.
  OperatingSession(const Scenario& scenario, std::unique_ptr<Simulation> simulation, double aspect,
                   OperationWatch watch = {}, std::optional<OperationHistory> history = {},
                   bool paused = false);

  // Handles an event of mouse or keyboard. The event's position is in pixels from the lower left of
  // the viewport. Returns whether a tool, a dragger or the camera used the event.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);

  // Takes from the operation what has changed since the last call of update(), and runs Inventor's
  // sensors. Returns the damage since that call.
  Damage update();
  // Tells the operation which tools have their tips in the picture.
  void noteSight(const SbViewportRegion& viewport);
  bool pending() const { return !damage_.empty(); }  // whether there is damage to draw

  // Plays the scenario's motions, frame by frame, up to the scenario time `until`, s. Begins where
  // the last call ended. If the motions are over or were stopped, begins at their start, with the
  // organs as they were at the start of the operation. Taking a tool stops the motions.
  void play(double until);
  bool playing() const { return playing_; }

  // undo() shows the moment before the last stroke, redo() the moment at which the last undo() was
  // called, and show() any moment (LiveOperation::show()). The tools go where they were at that
  // moment. Operating goes on from there when goOn() is called, or when the hand takes or moves an
  // instrument. undo() and redo() stop the motions; if there is nothing to undo or redo, the
  // operation stays at its moment.
  void undo();
  void redo();
  void show(Moment moment);
  // As LiveOperation::setPlayback().
  void setPlayback(double speed, std::int64_t branch) { operation_.setPlayback(speed, branch); }
  void goOn();
  // Whether bleeding ends of vessels are marked, and an instrument in hand that can stop bleeding
  // is guided to them. There are no marks while the hand has no such instrument. At first: true.
  void setBleedingMarks(bool marks) { marksBleeding_ = marks; }
  // setGuide() sets the guidance of a task that is drawn, or none. setGhosts() shows or hides the
  // ghosts of the scenario's instruments (GhostTools).
  void setGuide(std::optional<Guide> guide) { guide_ = std::move(guide); }
  void setGhosts(bool shown) { showsGhosts_ = shown; }
  bool hasGhosts() const { return ghosts_.any(); }
  // Distance of the instrument in hand from the guide (distanceFrom()), m; none without instrument
  // or guide.
  std::optional<double> guideDistance() const;
  void setIso(float iso);                                      // also calls goOn()
  bool answered() const { return asked_ == state_.answered; }  // whether all requests are done
  // Whether a moment of the history is shown, or has been requested.
  bool showing() const { return asked_ > state_.answered || (state_.showing && !goingOn_); }

  // Moves and turns the tool in hand. If there is none, moves the camera.
  void follow(const ViewMotion& motion);
  // Places the camera for one of the fixed views of the room. The surgeon's view is a close-up: the
  // organs fill about half of the picture. In thesis mode the surgeon's view also shows the tool
  // box and the scale.
  void look(RoomView view, double aspect);
  // Moves the camera, without turning it, so that organs, tool box and iso scale are in the
  // picture.
  void viewAll(double aspect);
  // Multiplies the camera's distance from its point of interest by `factor`.
  void zoom(double factor);
  // Shows or hides the scale of the iso level. In the picture it always stands left of the organs.
  void showScale(bool shown);
  // Stops the motions, puts all tools back to their rest poses, and shows the surgeon's view.
  void bringEverythingBack(double aspect);
  // The point that is seen at a pixel (PointedSurface::under()).
  std::optional<SurfacePoint> pointUnder(const SbVec2s& pixel,
                                         const SbViewportRegion& viewport) const;
  // The pixel of the viewport at which a point (world, m) is seen.
  SbVec2s pixelOf(const Vec3& point, const SbViewportRegion& viewport) const;
  // Middle of a tool's bounding box, world, m. A click there takes the tool if nothing hides it.
  Vec3 middleOfTool(int tool) const;

  SoNode* root() const { return view_.room().root(); }
  OperatingRoom& room() const { return view_.room(); }
  ToolHandling& tools() { return tools_; }
  CameraMoves& camera() { return camera_; }
  IsoDragger& iso() { return iso_; }
  LiveOperation& operation() { return operation_; }
  const LiveState& state() const { return state_; }
  const Scenario& scenario() const { return scenario_; }
  // Shows the operative field, or the table, from the next picture on.
  void showField(bool field);
  const std::vector<ToolModel>& toolModels() const { return toolModels_; }
  // Cells of the first organ before the operation.
  const Discretization& cells() const { return cells_; }

 private:
  Aabb allThereIs(const Vec3& towardsCamera) const;
  void placeScale();
  void keepAboveWall();
  void measureField();
  void toolsChanged();
  void setTools();
  void followHand();
  void followLooseBlood();
  void followBareVessels();
  void showBleeding();
  void showGuide();
  void followMotion();
  void followMoment();
  void leave();
  void handMoved();
  void stopPlaying();
  Vec3 lampPosition() const;

  Scenario scenario_;
  std::vector<ToolModel> toolModels_;
  Discretization cells_;
  Aabb organBox_;
  // The organs' silhouette in the surgeon's view before the operation: its middle, world, m, and
  // its area, m^2.
  Vec3 fieldMiddle_ = Vec3::Zero();
  double fieldArea_ = 0;
  mutable OperationView view_;
  ToolHandling tools_;
  CameraMoves camera_;
  IsoDragger iso_;
  TipMarker marker_;
  LineMarks aim_, bleeding_, guideMarks_;
  GhostTools ghosts_;
  SoHandleEventAction events_;
  Damage damage_{true, {}, {}};
  std::vector<Aabb> toolBoxes_;  // per tool: its bounding box when it last moved, world, m
  // Per tool: boxes of its slices along its axis, in the tool's frame, m.
  std::vector<std::vector<Aabb>> toolSlices_;
  // Per tool: boxes of its slices when it last moved, world, m; its bounding box if it had a
  // manipulator then.
  std::vector<std::vector<Aabb>> shownSlices_;
  std::shared_ptr<const LooseBlood> loose_;  // as drawn last
  std::shared_ptr<const BareVessels> bare_;  // as drawn last
  Aabb markerBox_;                           // of the marker under the tip, as shown last, world, m
  std::int64_t asked_ = 0;                   // number of the last request to the operation
  bool goingOn_ = false;                     // goOn() was called, and no frame has ended since
  bool following_ = false;                   // the tools are being set to the operation's poses
  bool playing_ = false;
  bool marksBleeding_ = true;
  std::optional<Guide> guide_;
  bool showsGhosts_ = false;
  std::int64_t played_ = 0, playUntil_ = 0;  // scenario frames: where play() begins and ends
  LiveState state_;
  LedgerWatch ledger_;  // moved into operation_ when that is made
  // The last member, so that its thread ends before the other members are destroyed.
  LiveOperation operation_;
};

}  // namespace resect

// An interactive operation without its window. It consists of the operating room, the handling of
// instruments, the camera, the scale of the iso level (inventor/hand/iso_dragger.h), and the live
// operation (LiveOperation).
//
// The only inputs are Inventor events, and calls of the functions below. So any window toolkit can
// use this class, and so can a test.
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
  // At first the tools are at their rest poses. A tool has its rest pose when it is not in use.
  // aspect (here and below): width / height of the picture. watch, history, paused: as in the
  // constructor of LiveOperation.
  OperatingSession(const Scenario& scenario, std::unique_ptr<Simulation> simulation, double aspect,
                   OperationWatch watch = {}, std::optional<OperationHistory> history = {},
                   bool paused = false);

  // Handles an event of mouse or keyboard. The event's position is in pixels from the lower left
  // corner of the viewport. Returns whether a tool, a dragger or the camera has used the event.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);

  // Brings the scene up to date with the operation, and runs Inventor's sensors. Returns the parts
  // of the picture that must be drawn again because of changes since the last call of update().
  Damage update();
  // Tells the operation which tools have their tips in the picture.
  void noteSight(const SbViewportRegion& viewport);
  bool pending() const { return !damage_.empty(); }  // whether there is damage to draw

  // Plays the scenario's motions, frame by frame, up to the scenario time `until`, s. The motions
  // continue where the last call of play() ended. If they had reached their end, or were stopped,
  // they begin again from the start, and the organs are as they were at the start of the operation.
  // If the user takes a tool, the motions stop.
  void play(double until);
  bool playing() const { return playing_; }
  // Whether the motions have reached their end, and nobody has taken an instrument since.
  bool playedOut() const { return playedOut_; }

  // These three functions show an earlier or later moment of the operation. A stroke is a period in
  // which instruments work on organs. undo() shows the moment before the last stroke. redo() shows
  // the moment at which the last undo() was called. show() shows any moment
  // (LiveOperation::show()). The tools go to the poses that they had at the shown moment. The
  // operation continues from the shown moment when goOn() is called, or when the user takes, moves
  // or lets go an instrument. Moving an instrument that only hovers over the surface has no such
  // effect. All three functions stop the scenario's motions. If there is nothing to undo or redo,
  // the operation stays at its present moment.
  void undo();
  void redo();
  void show(Moment moment);
  // Calls LiveOperation::setPlayback().
  void setPlayback(double speed, std::int64_t branch) { operation_.setPlayback(speed, branch); }
  // Lets the operation continue from the moment that is shown.
  void goOn();
  // Sets whether bleeding ends of vessels are marked. The ends are marked only while the hand has
  // an instrument that can stop bleeding. While the ends are marked, this instrument is also guided
  // to them. At first `marks` is true.
  void setBleedingMarks(bool marks) { marksBleeding_ = marks; }
  // setGuide() sets the guidance of a task, which is drawn from now on; without a guide nothing is
  // drawn. setGhosts() shows or hides the ghosts of the scenario's instruments (GhostTools).
  void setGuide(std::optional<Guide> guide) { guide_ = std::move(guide); }
  void setGhosts(bool shown) { showsGhosts_ = shown; }
  bool hasGhosts() const { return ghosts_.any(); }
  // Distance of the instrument in hand from the guide, m (distanceFrom() in
  // inventor/hand/marks/guide_marks.h). Returns nothing if the hand is empty or there is no guide.
  std::optional<double> guideDistance() const;
  void setIso(float iso);  // sets the iso level and calls goOn()
  // Whether the operation has carried out all requests.
  bool answered() const { return asked_ == state_.answered; }
  // Whether a moment of the history is shown, or has been requested.
  bool showing() const { return asked_ > state_.answered || (state_.showing && !goingOn_); }

  // Moves and turns the tool in hand. If the hand is empty, moves the camera instead.
  void follow(const ViewMotion& motion);
  // Places the camera for one of the fixed views of the room. The surgeon's view is a close-up: the
  // organs fill about half of the picture. In thesis mode (docs/window.md) the surgeon's view shows
  // all that viewAll() shows.
  void look(RoomView view, double aspect);
  // Moves the camera without turning it, so that the picture contains the organs and the scale of
  // the iso level, if the scale is shown. If the table is shown, the picture also contains the
  // instruments at their rest poses.
  void viewAll(double aspect);
  // Multiplies the camera's distance from its point of interest by `factor`.
  void zoom(double factor);
  // Shows or hides the scale of the iso level. In the picture the scale is always to the left of
  // the organs.
  void showScale(bool shown);
  // Stops the scenario's motions, puts all tools back to their rest poses, and shows the surgeon's
  // view.
  void bringEverythingBack(double aspect);
  // The point that is seen at a pixel (PointedSurface::under()).
  std::optional<SurfacePoint> pointUnder(const SbVec2s& pixel,
                                         const SbViewportRegion& viewport) const;
  // The pixel of the viewport at which a point is seen. point: world, m.
  SbVec2s pixelOf(const Vec3& point, const SbViewportRegion& viewport) const;
  // Middle of a tool's bounding box; world, m. A click at this point takes the tool if nothing
  // hides the tool.
  Vec3 middleOfTool(int tool) const;

  SoNode* root() const { return view_.room().root(); }
  OperatingRoom& room() const { return view_.room(); }
  ToolHandling& tools() { return tools_; }
  CameraMoves& camera() { return camera_; }
  IsoDragger& iso() { return iso_; }
  LiveOperation& operation() { return operation_; }
  const LiveState& state() const { return state_; }
  const Scenario& scenario() const { return scenario_; }
  // From the next picture on, shows the operative field (true) or the table (false).
  void showField(bool field);
  void showHands(bool shown);      // from the next picture on
  void moveLamp(LampPlace place);  // from the next picture on
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
  void followAdnexa();
  void followSmoke();
  void followBlood();
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
  // Middle (world, m) and area (m^2) of the organs' silhouette in the surgeon's view before the
  // operation.
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
  // For each tool: its bounding box after its last motion; world, m.
  std::vector<Aabb> toolBoxes_;
  // For each tool: boxes of the slices into which its mesh is cut along the Z axis; in the tool's
  // frame, m.
  std::vector<std::vector<Aabb>> toolSlices_;
  // For each tool: the boxes of its slices after its last motion; world, m. If the tool was held
  // with a manipulator, this is its bounding box instead.
  std::vector<std::vector<Aabb>> shownSlices_;
  std::vector<Aabb> shownHands_;  // for each tool: the bounds of its hand that were drawn last
  std::shared_ptr<const LooseBlood> loose_;    // blood that was drawn last
  std::shared_ptr<const BareVessels> bare_;    // vessels that were drawn last
  std::shared_ptr<const SurfaceCopy> adnexa_;  // parts that hang on the organ, as drawn last
  Aabb smokeBox_;                              // round the smoke that was drawn last
  Aabb markerBox_;          // box of the marker at the tip that was shown last; world, m
  std::int64_t asked_ = 0;  // number of the last request to the operation
  // goOn() was called, and the operation still shows an earlier or later moment.
  bool goingOn_ = false;
  bool following_ = false;  // the tools are being set to the operation's poses
  bool playing_ = false, playedOut_ = false;
  bool marksBleeding_ = true;
  std::optional<Guide> guide_;
  bool showsGhosts_ = false;
  // Frames of the scenario at which play() begins and ends.
  std::int64_t played_ = 0, playUntil_ = 0;
  LiveState state_;
  LedgerWatch ledger_;  // the constructor moves it into operation_
  // This must be the last member, so that its thread ends before the other members are destroyed.
  LiveOperation operation_;
};

}  // namespace resect

// Takes and moves tools with mouse and keyboard.
//
// As in the original thesis: a left click on a tool replaces its SoTransform by a handle box, which
// moves it; a middle click toggles to a trackball, which turns it, and back; a click elsewhere
// lets go and restores the SoTransform. The scale that a handle box's cubes and sides would set is
// ignored: instruments neither grow nor move by it. And directly: pressing on a tool and dragging
// moves it in the plane of the view, the wheel in depth, with Shift it turns about its tip; arrow
// keys and page keys do the same, 1 2 3 take tools, Escape puts the tool back, C held down closes
// its jaws. One tool is held at a time.
//
// Listens through an SoEventCallback at the start of the scene, so a window and a test get the same
// behaviour. Events that are not for tools, such as those that move the camera, are left unhandled.
#pragma once

#include <Inventor/SbVec2s.h>
#include <Inventor/SbVec3f.h>

#include <functional>
#include <vector>

#include "geometry/pose.h"
#include "inventor/scene/operating_room.h"

class SoDragger;
class SoEventCallback;
class SoHandleEventAction;
class SoPath;
class SoTransformManip;

namespace resect {

class ToolHandling {
 public:
  enum class Hold { None, Direct, HandleBox, Trackball };

  // `rests`: rest pose of each of the room's tools. The room must outlive this.
  ToolHandling(OperatingRoom& room, std::vector<Pose> rests);
  ~ToolHandling();
  ToolHandling(const ToolHandling&) = delete;
  ToolHandling& operator=(const ToolHandling&) = delete;

  int toolCount() const { return int(rests_.size()); }
  int held() const { return held_; }  // -1: none
  Hold how() const { return how_; }
  bool squeezing() const { return squeezing_; }  // the held tool's jaws are being closed
  // World pose of a tool; it has no scale.
  Pose pose(int tool) const;

  // Takes a tool in hand in this way, letting go of another; tool -1 or Hold::None lets go. A tool
  // taken directly from its rest pose is turned to its working rotation.
  void hold(int tool, Hold how);
  // The same with Hold::Direct; from its rest pose the tool moves to readyPlace.
  void take(int tool);
  // Puts the tool into the tool box, out of hand.
  void putBack(int tool);
  void setPose(int tool, const Pose& pose);

  // Moves the held tool, if any, by metres to the right, up and away in the view.
  void move(const Vec3& inView);
  // Turns it about its tip, by radians about the view's right, up and away axes.
  void turn(const Vec3& inView);

  // Position over the organ to which tools go when taken by key.
  Vec3 readyPlace = Vec3(0, 0.25, 0);
  // Corrects where a tool is moved to, so that it does not go through the table.
  std::function<Pose(int tool, const Pose&)> constrain;

  // Called after a tool was taken, let go, or moved.
  std::function<void()> changed;

 private:
  void requireTool(int tool) const;
  static void heard(void* self, SoEventCallback* node);
  void mouseButton(SoEventCallback& node);
  void mouseMoved(SoEventCallback& node);
  void key(SoEventCallback& node);
  int toolUnder(SoEventCallback& node, bool& dragger) const;
  void attach(int tool, Hold how);
  void detach();
  static void draggerMoved(void* self, SoDragger* dragger);
  Vec3 onScreen(const Vec3& inView) const;  // view axes -> world
  double metresPerPixel(const SoHandleEventAction& action) const;
  bool atRest(int tool) const;
  void notify() const {
    if (changed) changed();
  }

  OperatingRoom& room_;
  SoEventCallback* events_;
  std::vector<Pose> rests_;
  mutable std::vector<SoPath*> bodies_;  // path to each tool's body, found on demand
  int held_ = -1;
  Hold how_ = Hold::None;
  bool squeezing_ = false;
  Hold precise_ = Hold::HandleBox;  // which manipulator comes on a click
  SbVec3f place_;                   // of the tool in it, before its dragger scales

  // From a press until the release.
  int pressed_ = -1;            // tool that the drag moves
  bool elsewhere_ = false;      // pressed beside all tools
  bool dragging_ = false;       // moved far enough to be no click
  SbVec2s pressedAt_, lastAt_;  // pixels
};

}  // namespace resect

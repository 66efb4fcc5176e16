// Takes and moves tools with mouse and keyboard.
//
// With manipulators, as in the original thesis: a left click on a tool replaces its SoTransform by
// a handle box, which moves the tool. A middle click changes between the handle box and a
// trackball, which turns the tool. The next tool that is taken gets whichever of the two was used
// last. A click beside all tools
// lets go and restores the SoTransform. The scale that a handle box would set is ignored, so
// instruments neither change their size nor move by it.
//
// Directly: dragging a tool moves it in the plane of the view, and the wheel moves it in depth;
// with Shift both turn it about its tip. Arrow keys and page keys do the same as these two. Keys 1
// to 9 take a tool, Escape puts it back, C closes its jaws while held down. One tool is held at a
// time.
//
// Events come through an SoEventCallback at the start of the scene, so that a window and a test get
// the same behaviour. Events that are not for tools, such as those that move the camera, stay
// unhandled.
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

  // `rests`: for each tool of the room its pose in the tool box. The room must outlive this object.
  ToolHandling(OperatingRoom& room, std::vector<Pose> rests);
  ~ToolHandling();
  ToolHandling(const ToolHandling&) = delete;
  ToolHandling& operator=(const ToolHandling&) = delete;

  int toolCount() const { return int(rests_.size()); }
  int held() const { return held_; }  // -1: none
  Hold how() const { return how_; }
  bool squeezing() const { return squeezing_; }  // the held tool's jaws are being closed
  // World pose of a tool, without the scale that a handle box may have set.
  Pose pose(int tool) const;

  // Takes a tool in hand in this way and lets go of another; tool -1 or Hold::None only lets go. A
  // tool that is taken with Hold::Direct from its rest pose turns to its working rotation.
  void hold(int tool, Hold how);
  // hold(tool, Hold::Direct); a tool at its rest pose also moves to readyPlace.
  void take(int tool);
  // Puts the tool back to its rest pose, out of hand.
  void putBack(int tool);
  void setPose(int tool, const Pose& pose);

  // Moves the held tool, if any, by metres to the right, up and away in the view.
  void move(const Vec3& inView);
  // Turns the held tool, if any, about its tip: by radians about the view's right, up and away
  // axes.
  void turn(const Vec3& inView);

  // Where take() puts the tip of a tool from the tool box; world, m.
  Vec3 readyPlace = Vec3(0, 0.25, 0);
  // If set: corrects the pose of every setPose(), move() and turn(), so that a tool does not go
  // through the table. What a manipulator does is not corrected.
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
  Hold precise_ = Hold::HandleBox;  // the manipulator that a click brings
  SbVec3f place_;                   // its translation before its dragger changed the scale

  // From the press of the left button until its release.
  int pressed_ = -1;            // tool that the drag moves
  bool elsewhere_ = false;      // pressed beside all tools while one was held
  bool dragging_ = false;       // has moved too far for a click
  SbVec2s pressedAt_, lastAt_;  // pixels
};

}  // namespace resect

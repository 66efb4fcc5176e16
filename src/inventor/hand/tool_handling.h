// Takes and moves tools with mouse and keyboard.
//
// A tool can be held with a manipulator, as in the original thesis. A left click on a tool replaces
// its SoTransform by a handle box, which moves the tool. A middle click replaces the handle box by
// a trackball, which turns the tool; another middle click brings back the handle box. The next left
// click on a tool gives it the manipulator of these two that was used last. A click beside all
// tools lets go of the tool and restores its SoTransform. If the user scales the tool with the
// handle box, the scale is ignored: the tool keeps its size and its position.
//
// A tool can also be held directly. Dragging the tool moves it in the plane of the view; the wheel
// moves it in depth. With Shift, dragging or the wheel turns the tool about its tip. The arrow keys
// do the same as dragging, the page keys the same as the wheel. The keys of
// inventor/hand/tool_keys.h take a tool; Escape puts the tool in hand back. The tool's jaws are
// closed while C is held down, and its pedal is pressed while P is held down.
//
// If guide() was called, a tool that is taken follows the organ's surface instead
// (operation/hand/surface_hand.h): it hovers over the point under the pointer, and works while the
// left button is down. The wheel and the page keys change how deep it works; with Shift the mouse
// and the wheel turn its edge.
//
// One tool is in hand at a time. Other tools can be left where they are, holding or pressing
// (leave()): they go on working without the hand.
//
// Events come through an SoEventCallback at the start of the scene, so that a window and a test get
// the same behaviour. Events that are not for tools, such as those that move the camera, stay
// unhandled.
#pragma once

#include <Inventor/SbVec2s.h>
#include <Inventor/SbVec3f.h>
#include <Inventor/SbViewportRegion.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/pose.h"
#include "inventor/hand/pointed_surface.h"
#include "inventor/scene/operating_room.h"
#include "operation/hand/surface_hand.h"

class SoDragger;
class SoEventCallback;
class SoHandleEventAction;
class SoPath;
class SoTransformManip;

namespace resect {

class ToolHandling {
 public:
  enum class Hold { None, Direct, Guided, HandleBox, Trackball };

  // `rests`: per tool of the room, its rest pose. The room must outlive this object.
  ToolHandling(OperatingRoom& room, std::vector<Pose> rests);
  ~ToolHandling();
  ToolHandling(const ToolHandling&) = delete;
  ToolHandling& operator=(const ToolHandling&) = delete;

  int toolCount() const { return int(rests_.size()); }
  int held() const { return held_; }             // number of the tool in hand; -1: none
  Hold how() const { return how_; }              // how the tool in hand is held
  bool squeezing() const;                        // whether the hand closes this tool's jaws
  bool pedalling() const { return pedalling_; }  // whether the foot presses the pedal
  bool hasPedal() const;                         // whether the tool in hand has a pedal
  bool pressing() const { return how_ == Hold::Guided && hand_.pressing; }
  // isLeft(): whether the tool was left holding or pressing. left(): one value per tool; 1: it was
  // left so, 0: it was not.
  bool isLeft(int tool) const { return left_[std::size_t(tool)] != 0; }
  const std::vector<std::uint8_t>& left() const { return left_; }
  // Working depth of a guided tool below the surface, m.
  double depth(int tool) const { return depths_[std::size_t(tool)]; }
  // World pose of a tool, without the scale that a handle box may have set.
  Pose pose(int tool) const;

  // From now on, tools that are taken follow the surface, and stay above the table. models: one per
  // tool; must outlive this object.
  void guide(std::span<const ToolModel> models);
  // How a tool is held after it was taken by its number or dragged: Guided, or Direct without
  // guide().
  Hold usual() const { return models_.empty() ? Hold::Direct : Hold::Guided; }
  // The hand that guides the tool over the surface; null unless the tool in hand is guided and has
  // been pointed at a surface.
  const SurfaceHand* surfaceHand() const;
  // The pose of the tool in hand at which it began to press; only while pressing().
  const Pose& pressedFrom() const { return pressedFrom_; }
  // The pose that the hand wants for a tool. It differs from pose() only for a guided tool in hand;
  // the caller must move the tool there.
  Pose wanted(int tool) const;

  // Lets go of the tool in hand, and then holds `tool` in the way `how`. With tool -1 or Hold::None
  // no tool is held afterwards. A tool that is taken from its rest pose with Hold::Direct gets its
  // working rotation (operation/room.h), and its tip moves to where the tool's middle was.
  void hold(int tool, Hold how);
  // Calls hold(tool, usual()). If the tool was at its rest pose, its tip moves to readyPlace, or to
  // where the pointer is. With guide(), the tool that was in hand before is put back, or is left
  // at work if it was pressing.
  void take(int tool);
  // Leaves the tool in hand where it is, holding or pressing, until it is taken again or put back.
  void leave();
  // Sets which tools are left, one value per tool, when an earlier moment is shown.
  void setLeft(const std::vector<std::uint8_t>& left) { left_ = left; }
  // Moves the tool to its rest pose, and lets go of it if it is in hand.
  void putBack(int tool);
  void setPose(int tool, const Pose& pose);
  // To be called after the camera moved: points at the surface that is now under the pointer.
  void aimAgain();
  // Sets places, world, m. When the hand points near one of them, the tool in hand works there
  // (seek()).
  void setTargets(std::vector<Vec3> targets);
  // Ends a drag: the mouse moves no tool until a button is pressed again.
  void interrupt();

  // Moves the tool in hand, if any. inView: distances to the right, up and away from the viewer, m.
  void move(const Vec3& inView);
  // Turns the tool in hand, if any, about its tip. inView: angles about the axes to the right, up
  // and away from the viewer, rad.
  void turn(const Vec3& inView);

  // Where take() puts the tip of a tool from the tool box; world, m.
  Vec3 readyPlace = Vec3(0, 0.25, 0);
  // If set: returns a corrected pose for each pose that a tool is to get, so that the tool does not
  // go through the table. Poses from a manipulator and rest poses are not corrected.
  std::function<Pose(int tool, const Pose&)> constrain;

  // Called after a tool was taken, let go or moved, when its jaws begin or cease to close,
  // and when the pedal goes down or up.
  std::function<void()> changed;
  // Called when the mouse button with which a tool was moved, or pressed, is released.
  std::function<void()> released;

 private:
  void requireTool(int tool) const;
  static void heard(void* self, SoEventCallback* node);
  void takeUpHeld();
  void aim(const SbVec2s& pixel, const SbViewportRegion& viewport);
  void seekUnder(const SbVec2s& pixel, const SbViewportRegion& viewport);
  void startPress();
  void endPress();
  void guidedButton(SoEventCallback& node, bool down);
  void guidedMove(SoEventCallback& node);
  void guidedWheel(double notches, bool turning);
  void mouseButton(SoEventCallback& node);
  void mouseMoved(SoEventCallback& node);
  void key(SoEventCallback& node);
  int toolUnder(SoEventCallback& node, bool& dragger) const;
  void attach(int tool, Hold how);
  void detach();
  static void draggerMoved(void* self, SoDragger* dragger);
  Vec3 onScreen(const Vec3& inView) const;  // a vector along the view's axes, in world axes
  double metresPerPixel(const SoHandleEventAction& action) const;
  SbVec2s pixelsOf(const Vec3& inView, const SoHandleEventAction& action) const;
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
  bool squeezing_ = false;          // the key that closes jaws is down
  bool pedalling_ = false;          // the key that presses the pedal is down
  std::vector<std::uint8_t> left_;  // per tool; 1: left holding or pressing
  Hold precise_ = Hold::HandleBox;  // manipulator of the next left click
  SbVec3f place_;                   // the manipulator's translation before it last set a scale

  std::span<const ToolModel> models_;  // per tool; empty without guide()
  std::vector<double> depths_;         // per tool: how deep it works, m
  SurfaceHand hand_;                   // of the tool in hand, if it is guided
  std::vector<Vec3> targets_;
  Pose pressedFrom_;
  PointedSurface pointed_;
  // Last position of the pointer. A guided tool goes there when it is taken.
  SbVec2s pointer_;
  std::optional<SbViewportRegion> viewport_;

  // The members below are valid from the press of the left button until its release.
  int pressed_ = -1;            // tool that the drag moves
  bool elsewhere_ = false;      // pressed beside all tools while a tool was held
  bool dragging_ = false;       // the pointer moved too far for a click
  SbVec2s pressedAt_, lastAt_;  // pixels
};

}  // namespace resect

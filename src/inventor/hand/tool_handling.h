// Lets the user take and move tools with mouse and keyboard.
//
// A tool can be held with a manipulator. There are two manipulators: a handle box, which moves the
// tool, and a trackball, which turns the tool. A left click on a tool replaces the tool's
// SoTransform by a manipulator. At first this manipulator is the handle box. Later it is the
// manipulator that was used last. A middle click replaces the handle box by the trackball, or the
// trackball by the handle box. A left click beside all tools lets go of the tool in hand and
// restores its SoTransform. If the user tries to scale the tool with the handle box, the tool keeps
// its size and its position.
//
// A tool can also be held directly. If the user drags the tool, it moves parallel to the plane of
// the picture. The wheel moves the tool in depth. With Shift, dragging and the wheel turn the tool
// about its tip. The arrow keys act like dragging, and the page keys act like the wheel. The keys
// of inventor/hand/tool_keys.h take a tool. Escape puts the tool in hand back. While C is held
// down, the tool's jaws are closed. While P is held down, the tool's pedal is pressed.
//
// If guide() was called, a tool is guided after it is taken (operation/hand/surface_hand.h): it
// hovers over the point of the surface at which the pointer points, and works while the left button
// is down. The wheel and the page keys change the working depth. With Shift, the mouse and the
// wheel turn the tool's edge.
//
// At most one tool is in hand. Other tools can be left at work (leave()): they stay where they are,
// and go on holding or pressing.
//
// Events come through an SoEventCallback at the start of the scene, so windows and tests see the
// same behaviour. Events that are not for tools, such as events that move the camera, stay
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

  // rests: the rest poses of the room's tools. The room must outlive this object.
  ToolHandling(OperatingRoom& room, std::vector<Pose> rests);
  ~ToolHandling();
  ToolHandling(const ToolHandling&) = delete;
  ToolHandling& operator=(const ToolHandling&) = delete;

  int toolCount() const { return int(rests_.size()); }
  int held() const { return held_; }             // number of the tool in hand; -1: none
  Hold how() const { return how_; }              // how the tool in hand is held
  bool squeezing() const;                        // whether the hand closes the tool's jaws
  bool pedalling() const { return pedalling_; }  // whether the foot presses the pedal
  bool hasPedal() const;                         // whether the tool in hand has a pedal
  // Whether a guided tool is in hand and works.
  bool pressing() const { return how_ == Hold::Guided && hand_.pressing; }
  // isLeft() says whether a tool is left at work. left() has one value per tool: 1 if the tool is
  // left at work, otherwise 0.
  bool isLeft(int tool) const { return left_[std::size_t(tool)] != 0; }
  const std::vector<std::uint8_t>& left() const { return left_; }
  // Working depth of a guided tool below the surface, m.
  double depth(int tool) const { return depths_[std::size_t(tool)]; }
  // Whether a guided tool cannot work less deep.
  bool isLeastDeep(int tool) const {
    const double least = styles_[std::size_t(tool)].leastDepth;
    return least > 0 && depth(tool) <= least;
  }
  // Whether a guided tool cannot work deeper.
  bool isMostDeep(int tool) const { return depth(tool) >= styles_[std::size_t(tool)].mostDepth; }
  // Pose of a tool in the world. A scale that a handle box may have set is ignored.
  Pose pose(int tool) const;

  // From now on, tools that are taken follow the surface of the organs and stay above the table.
  // models: one model per tool. They must outlive this object. spacing: side of the tissue's cells,
  // m (handStyleOf()).
  void guide(std::span<const ToolModel> models, double spacing);
  // How a tool is held after take(): Guided if guide() was called, otherwise Direct.
  Hold usual() const { return models_.empty() ? Hold::Direct : Hold::Guided; }
  // The hand that guides the tool over the surface. Null unless the tool in hand is guided and the
  // pointer has pointed at a surface.
  const SurfaceHand* surfaceHand() const;
  // The pose that the tool in hand had when it began to press. Valid only while pressing() is true.
  const Pose& pressedFrom() const { return pressedFrom_; }
  // The pose that a tool should have. It differs from pose() only if the tool is guided and in
  // hand. In this case the caller must move the tool to the wanted pose.
  Pose wanted(int tool) const;

  // Lets go of the tool in hand, and then holds `tool` in the manner `how`. If `tool` is -1 or
  // `how` is Hold::None, no tool is held afterwards. If `how` is Hold::Direct and the tool is at
  // its rest pose, the tool gets the rotation workingRotation() (operation/room.h), and its tip
  // moves to where the middle of the tool was.
  void hold(int tool, Hold how);
  // Calls hold(tool, usual()). If the tool was at its rest pose, its tip moves to readyPlace. If
  // the tool is guided and the pointer is over a surface, the tool moves to the pointer instead. If
  // guide() was called, the tool that was in hand before is put back. But if that tool was
  // pressing, it is left at work.
  void take(int tool);
  // Leaves the tool in hand at work, until it is taken again or put back.
  void leave();
  // Sets which tools are left at work, when an earlier moment is shown. left: as left() returns it.
  void setLeft(const std::vector<std::uint8_t>& left) { left_ = left; }
  // Moves a tool to its rest pose. If the tool is in hand, lets go of it.
  void putBack(int tool);
  void setPose(int tool, const Pose& pose);
  // Call this after the camera has moved. A guided tool then points at the surface that is now seen
  // under the pointer.
  void aimAgain();
  // Sets target points; world, m. When the user points near a target, the tool in hand works at
  // that target (seek() in operation/hand/surface_hand.h).
  void setTargets(std::vector<Vec3> targets);
  // Ends a drag: until a button is pressed again, the mouse moves no tool.
  void interrupt();

  // Moves the tool in hand. Does nothing if the hand is empty. inView: distances to the right, up
  // and away from the viewer, m.
  void move(const Vec3& inView);
  // Turns the tool in hand about its tip. Does nothing if the hand is empty. inView: rotation
  // vector, rad; its components are along the axes to the right, up and away from the viewer.
  void turn(const Vec3& inView);

  // Where take() puts the tip of a tool that was at its rest pose; world, m.
  Vec3 readyPlace = Vec3(0, 0.25, 0);
  // Corrects the pose that a tool is to get, so that the tool does not go through the table. The
  // function may be empty. It is not called for rest poses, or for poses that a manipulator sets.
  std::function<Pose(int tool, const Pose&)> constrain;

  // Called after a tool was taken, let go or moved. Also called when the user begins or ceases to
  // close the jaws or to press the pedal.
  std::function<void()> changed;
  // Called when the user releases the mouse button after dragging a tool, or after working with a
  // guided tool. Also called by leave().
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
  // Converts a vector from the axes right, up and away from the viewer to the axes of the world.
  Vec3 onScreen(const Vec3& inView) const;
  double metresPerPixel(const SoHandleEventAction& action) const;
  SbVec2s pixelsOf(const Vec3& inView, const SoHandleEventAction& action) const;
  bool atRest(int tool) const;
  void notify() const {
    if (changed) changed();
  }

  OperatingRoom& room_;
  SoEventCallback* events_;
  std::vector<Pose> rests_;
  mutable std::vector<SoPath*> bodies_;  // for each tool the path to its model; null: not found yet
  int held_ = -1;
  Hold how_ = Hold::None;
  bool squeezing_ = false;          // the key that closes jaws is down
  bool pedalling_ = false;          // the key that presses the pedal is down
  std::vector<std::uint8_t> left_;  // for each tool: 1 if it is left at work, otherwise 0
  Hold precise_ = Hold::HandleBox;  // manipulator that the next left click attaches
  SbVec3f place_;                   // the manipulator's translation before it was scaled

  std::span<const ToolModel> models_;  // one per tool; empty before guide() is called
  std::vector<HandStyle> styles_;      // for each tool
  std::vector<double> depths_;         // for each tool: its working depth, m
  SurfaceHand hand_;                   // guides the tool in hand if `how_` is Guided
  std::vector<Vec3> targets_;
  Pose pressedFrom_;
  PointedSurface pointed_;
  // Last position of the pointer, and the viewport at that time. A guided tool goes to this
  // position when it is taken.
  SbVec2s pointer_;
  std::optional<SbViewportRegion> viewport_;

  // The members below are valid while the left button is held down.
  int pressed_ = -1;        // number of the tool that a drag moves; -1: none
  bool elsewhere_ = false;  // the button went down beside all tools while a tool was held
  bool dragging_ = false;   // the pointer has moved too far for a click
  // Pixels of the pointer: where the button went down, and at the last motion.
  SbVec2s pressedAt_, lastAt_;
};

}  // namespace resect

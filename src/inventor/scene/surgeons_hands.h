// The gloved hands in which instruments are held.
//
// Three models (data/room/hand_*.iv) show a right hand: one that holds a handle like a pen, one
// that grips a rod, and one with its fingers in two rings. A left hand is the mirror image of a
// right one. Hands are scenery: they touch nothing, cast no shadow and cannot be picked.
#pragma once

#include <optional>
#include <string>

#include "geometry/pose.h"
#include "tools/tool.h"

class SoNode;

namespace resect {

// How a tool is held. The frame of a hand's model: its origin is where the fingers hold the handle,
// +Z points along the handle away from the tool's tip, and the forearm leaves towards +X and +Z.
struct HandGrip {
  std::string model;       // of readRoomModel()
  Vec3 at = Vec3::Zero();  // the hand's origin in the tool's frame, m
  bool left = false;       // whether it is a left hand
  // Whether the hand can turn about the handle, so that its forearm comes from the surgeon. A hand
  // in rings cannot.
  bool turns = true;
};

// The grip for a tool whose handle lies along +Z. Returns nothing if no hand holds tools of its
// kind, or if its handle is too short for the grip.
std::optional<HandGrip> gripOf(const ToolModel& tool);

// Pose of the hand; world. tool: the tool's pose.
Pose handPose(const HandGrip& grip, const Pose& tool);

// A new scene graph of the hand in the hand's frame, with its materials. Throws Error if the file
// cannot be read.
SoNode* makeHand(const HandGrip& grip);

}  // namespace resect

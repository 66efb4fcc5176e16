#include "inventor/scene/surgeons_hands.h"

#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoScale.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "inventor/gl/materials.h"
#include "inventor/scene/room_models.h"

namespace resect {
namespace {

struct KindOfGrip {
  std::string_view kind;
  const char* model;
  double y, z;  // of HandGrip::at, m
  bool left, turns;
};

constexpr std::array kGrips = {
    KindOfGrip{"scalpel", "hand_pen", -0.003, 0.080, false, true},
    KindOfGrip{"pencil", "hand_pen", 0, 0.060, false, true},
    KindOfGrip{"bipolar", "hand_pen", 0, 0.105, false, true},
    KindOfGrip{"forceps", "hand_pen", 0, 0.105, true, true},
    KindOfGrip{"aspirator", "hand_rod", 0, 0.135, false, true},
    KindOfGrip{"suction", "hand_rod", 0.0105, 0.140, true, true},
    KindOfGrip{"hook", "hand_rod", 0.010, 0.135, true, true},
    KindOfGrip{"baton", "hand_rod", 0, 0.130, false, true},
    KindOfGrip{"scissors", "hand_rings", 0, 0.1535, false, false},
    KindOfGrip{"clip_applier", "hand_rings", 0, 0.1708, false, false},
    KindOfGrip{"inflow_clamp", "hand_rings", 0, 0.1714, true, false},
    KindOfGrip{"gauze", "hand_rings", 0, 0.1715, true, false},
};

// Where the surgeon's elbows are; world, m. The surgeon stands at +Z.
const Vec3 kRightElbow(0.28, 0.20, 0.50), kLeftElbow(-0.28, 0.20, 0.50);

}  // namespace

std::optional<HandGrip> gripOf(const ToolModel& tool) {
  constexpr double kBehind = 0.005;  // m: least length of the handle behind the hand's origin
  for (const KindOfGrip& grip : kGrips) {
    if (tool.kind != grip.kind) continue;
    double length = 0;
    for (const Vec3& p : tool.mesh.points) length = std::max(length, p.z());
    if (length < grip.z + kBehind) return std::nullopt;
    return HandGrip{grip.model, Vec3(0, grip.y, grip.z), grip.left, grip.turns};
  }
  return std::nullopt;
}

Pose handPose(const HandGrip& grip, const Pose& tool) {
  Pose hand{tool * grip.at, tool.rotation};
  const Vec3 elbow =
      tool.rotation.conjugate() * Vec3((grip.left ? kLeftElbow : kRightElbow) - hand.position);
  double turn = std::atan2(elbow.y(), elbow.x());
  if (!grip.turns) turn = std::abs(turn) > 0.5 * std::numbers::pi ? std::numbers::pi : 0;
  hand.rotation = tool.rotation * Eigen::AngleAxisd(turn, Vec3::UnitZ());
  return hand;
}

SoNode* makeHand(const HandGrip& grip) {
  auto* hand = uncachedSeparator();
  SoNode* model = readRoomModel(grip.model);
  model->ref();
  if (grip.left) {
    auto* mirror = new SoScale;
    mirror->scaleFactor = SbVec3f(1, -1, 1);
    hand->addChild(mirror);
    SoSearchAction search;
    search.setType(SoShapeHints::getClassTypeId());
    search.setInterest(SoSearchAction::ALL);
    search.apply(model);
    for (int i = 0; i < search.getPaths().getLength(); ++i)
      static_cast<SoShapeHints*>(search.getPaths()[i]->getTail())->vertexOrdering =
          SoShapeHints::CLOCKWISE;
  }
  hand->addChild(withMaterial(RoomMaterial::Glove, {model}));
  model->unref();
  return hand;
}

}  // namespace resect

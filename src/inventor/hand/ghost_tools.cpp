#include "inventor/hand/ghost_tools.h"

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTransparencyType.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/moved_box.h"
#include "inventor/scene/operating_room.h"

namespace resect {
namespace {

constexpr double kSeen = 1e-3;  // m: smaller motions are not shown

SoNode* meshNode(const TriangleMesh& mesh) {
  auto* group = new SoSeparator;
  auto* corners = new SoCoordinate3;
  auto* faces = new SoIndexedFaceSet;
  int i = 0;
  for (const auto& p : mesh.points)
    corners->point.set1Value(i++, float(p.x()), float(p.y()), float(p.z()));
  i = 0;
  for (const Triangle& t : mesh.triangles)
    for (const std::int32_t index : {t[0], t[1], t[2], -1}) faces->coordIndex.set1Value(i++, index);
  group->addChild(corners);
  group->addChild(faces);
  return group;
}

}  // namespace

GhostTools::GhostTools(SoSeparator* parent, const Scenario& scenario,
                       std::span<const ToolModel> models)
    : scenario_(scenario), parent_(parent), root_(new SoSwitch) {
  auto* group = new SoSeparator;
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  auto* sieve = new SoTransparencyType;
  sieve->value = SoTransparencyType::SCREEN_DOOR;
  auto* pale = new SoMaterial;
  pale->diffuseColor.setValue(0.55f, 0.8f, 0.95f);
  pale->transparency = 0.55f;
  for (SoNode* node : std::initializer_list<SoNode*>{unpickable, unlit, sieve, pale})
    group->addChild(node);
  bool first = true;
  for (std::size_t t = 0; t < scenario.tools.size(); ++t) {
    const std::vector<ToolKey>& keys = scenario.tools[t].keys;
    if (keys.empty()) continue;
    begin_ = first ? keys.front().time : std::min(begin_, keys.front().time);
    end_ = std::max(end_, keys.back().time);
    first = false;
    Ghost ghost{t, bounds(models[t].mesh), new SoSwitch, new SoTransform, {}};
    auto* body = new SoSeparator;
    body->addChild(ghost.place);
    body->addChild(meshNode(models[t].mesh));
    ghost.shown->addChild(body);
    ghost.shown->whichChild = SO_SWITCH_NONE;
    group->addChild(ghost.shown);
    ghosts_.push_back(ghost);
  }
  root_->addChild(group);
  root_->whichChild = SO_SWITCH_NONE;
  parent_->addChild(root_);
}

GhostTools::~GhostTools() { parent_->removeChild(root_); }

Aabb GhostTools::hide() {
  root_->whichChild = SO_SWITCH_NONE;
  for (Ghost& ghost : ghosts_) ghost.shown->whichChild = SO_SWITCH_NONE;
  return std::exchange(box_, {});
}

Aabb GhostTools::show(double time) {
  if (ghosts_.empty()) return {};
  root_->whichChild = SO_SWITCH_ALL;
  const double length = std::max(end_ - begin_, 1e-3);
  const double now = begin_ + std::fmod(std::max(0.0, time), length);
  const FrameInput input = frameInput(
      scenario_, std::min(frameCount(scenario_) - 1, std::int64_t(now * scenario_.frameRate)));
  Aabb changed, all;
  for (Ghost& ghost : ghosts_) {
    const ToolInput& tool = input.tools[ghost.tool];
    const bool was = ghost.shown->whichChild.getValue() != SO_SWITCH_NONE;
    const bool moved = (tool.pose.position - ghost.pose.position).norm() > kSeen;
    if (was == tool.inHand && !(tool.inHand && moved)) {
      if (was) all.grow(movedBox(ghost.bounds, ghost.pose));
      continue;
    }
    if (was) changed.grow(movedBox(ghost.bounds, ghost.pose));
    ghost.shown->whichChild = tool.inHand ? SO_SWITCH_ALL : SO_SWITCH_NONE;
    if (!tool.inHand) continue;
    ghost.pose = tool.pose;
    setPose(ghost.place, tool.pose);
    changed.grow(movedBox(ghost.bounds, ghost.pose));
    all.grow(movedBox(ghost.bounds, ghost.pose));
  }
  box_ = all;
  return changed.empty() ? changed : changed.padded(0.002);
}

}  // namespace resect

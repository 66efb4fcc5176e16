// The instruments in the room.
#include <Inventor/SoFullPath.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTexture2Transform.h>
#include <Inventor/nodes/SoTransform.h>

#include "base/error.h"
#include "inventor/gl/SoShadowMaps.h"
#include "inventor/gl/materials.h"
#include "inventor/gl/vectors.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"

namespace resect {
namespace {

SoSwitch* shownSwitch() {
  auto* choice = new SoSwitch;
  choice->whichChild = SO_SWITCH_ALL;
  return choice;
}

bool same(const Pose& a, const Pose& b) {
  return a.position == b.position && a.rotation.coeffs() == b.rotation.coeffs();
}

// Within what a scene graph's single precision loses.
bool near(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() < 1e-5 && a.rotation.angularDistance(b.rotation) < 1e-3;
}

Aabb boundsOf(SoNode* node) {
  SoGetBoundingBoxAction measure(SbViewportRegion(100, 100));
  measure.apply(node);
  const SbBox3f box = measure.getBoundingBox();
  if (box.isEmpty()) return {};
  const SbVec3f &low = box.getMin(), &high = box.getMax();
  return {Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2])};
}

// Blood, material and model of a tool.
SoSeparator* bodyOf(const SoSeparator* tools, int tool) {
  const auto* shown =
      static_cast<SoSwitch*>(static_cast<SoSeparator*>(tools->getChild(tool))->getChild(1));
  return static_cast<SoSeparator*>(shown->getChild(0));
}

}  // namespace

int OperatingRoom::addTool(SoNode* model) {
  require(model != nullptr, "a tool without a model was added to the room; give its scene graph");
  // The steel material applies to the model only, so that a manipulator in the transform's place
  // keeps its colours.
  SoSeparator* tool = uncachedSeparator();
  tool->addChild(new SoTransform);
  SoSwitch* shown = shownSwitch();
  SoSeparator* body = uncachedSeparator();
  body->addChild(new SoTexture2Transform);  // tells the shader how far the tool is bloody
  body->addChild(steel_);
  body->addChild(model);
  shown->addChild(body);
  shown->addChild(makePickProxy(model));
  tool->addChild(shown);
  tools_->addChild(tool);
  SoSeparator* shadow = uncachedSeparator();
  SoSwitch* cast = shownSwitch();
  cast->addChild(model);
  shadow->addChild(new SoTransform);
  shadow->addChild(cast);
  toolShadows_->addChild(shadow);
  jaws_.emplace_back();
  hiddenAt_.emplace_back();
  grips_.emplace_back();
  handsShown_->addChild(new SoSwitch);
  return tools_->getNumChildren() - 1;
}

int OperatingRoom::addTool(const ToolModel& tool) {
  ToolNodes nodes = makeToolNodes(tool);
  const int number = addTool(nodes.model);
  jaws_.back() = std::move(nodes.jaws);
  grips_.back() = gripOf(tool);
  return number;
}

void OperatingRoom::requireTool(int tool) const {
  require(tool >= 0 && tool < toolCount(), "there is no tool {} among the room's {}; number from 0",
          tool, toolCount());
}

bool OperatingRoom::setToolSqueeze(int tool, double squeeze) {
  requireTool(tool);
  bool turned = false;
  for (const ToolNodes::Jaw& jaw : jaws_[std::size_t(tool)]) {
    const SbRotation rotation(SbVec3f(jaw.axis.data()), float(1 - squeeze) * jaw.opens);
    if (jaw.transform->rotation.getValue() == rotation) continue;
    jaw.transform->rotation = rotation;
    turned = true;
  }
  return turned;
}

void OperatingRoom::setToolBlood(int tool, double reach) {
  requireTool(tool);
  SoTexture2Transform* blood = toolBlood(tool);
  const SbVec2f value(float(reach), 0);
  if (blood->translation.getValue() != value) blood->translation = value;
}

SoTexture2Transform* OperatingRoom::toolBlood(int tool) const {
  return static_cast<SoTexture2Transform*>(bodyOf(tools_, tool)->getChild(0));
}

SoTransform* OperatingRoom::toolTransform(int tool) const {
  requireTool(tool);
  return static_cast<SoTransform*>(static_cast<SoSeparator*>(tools_->getChild(tool))->getChild(0));
}

int OperatingRoom::toolOfPath(const SoFullPath& path) const {
  for (int i = 0; i + 1 < path.getLength(); ++i)
    if (path.getNode(i) == tools_) return tools_->findChild(path.getNode(i + 1));
  return -1;
}

int OperatingRoom::toolCount() const { return tools_->getNumChildren(); }

SoNode* OperatingRoom::toolModel(int tool) const {
  requireTool(tool);
  return bodyOf(tools_, tool)->getChild(2);
}

Aabb OperatingRoom::toolBounds(int tool) const {
  requireTool(tool);
  return boundsOf(tools_->getChild(tool));
}

Aabb OperatingRoom::handBounds(int tool) const {
  requireTool(tool);
  return handsAreSeen() ? boundsOf(handsShown_->getChild(tool)) : Aabb();
}

// A manipulator moves the tool's transform by itself.
void OperatingRoom::followTools() {
  for (int i = 0; i < toolCount(); ++i) {
    const Pose pose = getPose(*toolTransform(i));
    const auto* shadow = static_cast<SoSeparator*>(toolShadows_->getChild(i));
    auto* place = static_cast<SoTransform*>(shadow->getChild(0));
    if (!same(pose, getPose(*place))) setPose(place, pose);
    const auto& rest = hiddenAt_[std::size_t(i)];
    const int shown = rest && near(pose, *rest) ? SO_SWITCH_NONE : SO_SWITCH_ALL;
    for (SoNode* node :
         {static_cast<SoSeparator*>(tools_->getChild(i))->getChild(1), shadow->getChild(1)}) {
      auto* choice = static_cast<SoSwitch*>(node);
      if (choice->whichChild.getValue() != shown) choice->whichChild = shown;
    }
    followHand(i, pose, shown == SO_SWITCH_ALL);
  }
}

void OperatingRoom::hideAtRest(int tool, const std::optional<Pose>& rest) {
  requireTool(tool);
  hiddenAt_[std::size_t(tool)] = rest;
  followTools();
}

void OperatingRoom::setToolPose(int tool, const Pose& pose) {
  setPose(toolTransform(tool), pose);
  followTools();
}

}  // namespace resect

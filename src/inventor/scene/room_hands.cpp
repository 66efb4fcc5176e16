// The hands that hold the instruments.
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTexture2Transform.h>
#include <Inventor/nodes/SoTransform.h>

#include "inventor/gl/materials.h"
#include "inventor/scene/operating_room.h"

namespace resect {

bool OperatingRoom::handsAreSeen() const {
  return handsWanted_ && !throughScope() && field_->getNumChildren() > 0;
}

void OperatingRoom::followHand(int tool, const Pose& pose, bool toolShown) {
  const auto& grip = grips_[std::size_t(tool)];
  if (!grip || !handsAreSeen()) return;
  auto* shown = static_cast<SoSwitch*>(handsShown_->getChild(tool));
  const int which = toolShown ? 0 : SO_SWITCH_NONE;
  if (shown->whichChild.getValue() != which) shown->whichChild = which;
  if (!toolShown) return;
  if (shown->getNumChildren() == 0) {
    auto* unpickable = new SoPickStyle;
    unpickable->style = SoPickStyle::UNPICKABLE;
    auto* hand = uncachedSeparator();
    for (SoNode* node : {static_cast<SoNode*>(new SoTransform), static_cast<SoNode*>(unpickable),
                         static_cast<SoNode*>(new SoTexture2Transform), makeHand(*grip)})
      hand->addChild(node);
    shown->addChild(hand);
  }
  const auto* hand = static_cast<SoSeparator*>(shown->getChild(0));
  setPose(static_cast<SoTransform*>(hand->getChild(0)), handPose(*grip, pose));
  // Tells the shader how far from the fingers the tool's tip is, and how far the tool is bloody.
  static_cast<SoTexture2Transform*>(hand->getChild(2))->translation =
      SbVec2f(float(grip->at.z()), toolBlood(tool)->translation.getValue()[0]);
}

void OperatingRoom::showHands(bool shown) {
  handsWanted_ = shown;
  updateHands();
}

void OperatingRoom::updateHands() {
  handsShown_->whichChild = handsAreSeen() ? SO_SWITCH_ALL : SO_SWITCH_NONE;
  followTools();
}

}  // namespace resect

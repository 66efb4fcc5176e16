#include "inventor/hand/tip_marker.h"
#include "inventor/gl/vectors.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTranslation.h>

#include <cmath>
#include <numbers>

namespace resect {
namespace {

constexpr double kNear = 0.008;  // m: closer than this the tip glows
constexpr float kRing = 0.006f;  // m

}  // namespace

TipMarker::TipMarker(SoSeparator* parent) : parent_(parent), root_(new SoSwitch) {
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  root_->addChild(unpickable);

  auto* colour = new SoBaseColor;
  colour->rgb.setValue(0.75f, 0.90f, 0.95f);
  root_->addChild(colour);
  auto* plumb = new SoSeparator;
  plumb->renderCaching = SoSeparator::OFF;
  auto* dashed = new SoDrawStyle;
  dashed->linePattern = 0x6666;
  dashed->lineWidth = 1.5f;
  line_ = new SoCoordinate3;
  line_->point.setNum(2);
  auto* line = new SoLineSet;
  line->numVertices = 2;
  plumb->addChild(dashed);
  plumb->addChild(line_);
  plumb->addChild(line);
  root_->addChild(plumb);

  auto* ring = new SoSeparator;
  ringPlace_ = new SoTranslation;
  auto* style = new SoDrawStyle;
  style->lineWidth = 2;
  auto* circle = new SoCoordinate3;
  constexpr int kCorners = 24;
  for (int i = 0; i <= kCorners; ++i) {
    const float a = 2 * std::numbers::pi_v<float> * float(i) / kCorners;
    circle->point.set1Value(i, kRing * std::cos(a), 0, kRing * std::sin(a));
  }
  auto* round = new SoLineSet;
  round->numVertices = kCorners + 1;
  ring->addChild(ringPlace_);
  ring->addChild(style);
  ring->addChild(circle);
  ring->addChild(round);
  root_->addChild(ring);

  glowSwitch_ = new SoSwitch;
  glowPlace_ = new SoTranslation;
  glow_ = new SoMaterial;
  ball_ = new SoSphere;
  auto* ball = new SoSeparator;
  ball->addChild(glowPlace_);
  ball->addChild(glow_);
  ball->addChild(ball_);
  glowSwitch_->addChild(ball);
  root_->addChild(glowSwitch_);
  hide();
  parent_->addChild(root_);
}

TipMarker::~TipMarker() { parent_->removeChild(root_); }

void TipMarker::hide() {
  root_->whichChild = SO_SWITCH_NONE;
  shown_ = false;
}

bool TipMarker::show(const Vec3& tip, double below, double distance, bool touching) {
  if (shown_ && tip == tip_ && below == below_ && distance == distance_ && touching == touching_)
    return false;
  shown_ = true;
  tip_ = tip;
  below_ = below;
  distance_ = distance;
  touching_ = touching;
  root_->whichChild = SO_SWITCH_ALL;
  const Vec3 foot(tip.x(), std::min(below, tip.y()) + 0.0015, tip.z());
  line_->point.set1Value(0, toSb(tip));
  line_->point.set1Value(1, toSb(foot));
  ringPlace_->translation = toSb(foot);
  const bool glows = touching || distance < kNear;
  glowSwitch_->whichChild = glows ? SO_SWITCH_ALL : SO_SWITCH_NONE;
  if (!glows) return true;
  glowPlace_->translation = toSb(tip);
  // Amber and growing with nearness; bright on contact.
  const double nearness = touching ? 1 : 1 - distance / kNear;
  ball_->radius = float(0.0015 + 0.0020 * nearness);
  glow_->diffuseColor = touching ? SbColor(1.0f, 0.95f, 0.75f) : SbColor(1.0f, 0.66f, 0.16f);
  glow_->transparency = float(0.75 - 0.45 * nearness);
  return true;
}

}  // namespace resect

#include "inventor/hand/iso_dragger.h"

#include <Inventor/VRMLnodes/SoVRMLBillboard.h>
#include <Inventor/draggers/SoTranslate1Dragger.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoFont.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoText3.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/colour_field.h"

namespace resect {
namespace {

constexpr float kLength = 0.16f;   // m, of the scale from 0 to 100
constexpr float kHandle = 0.022f;  // m per unit of the dragger's own size

// In the dragger's frame, which is scaled and rotated so that its x axis points up the scale.
float toDragger(float iso) { return iso / 100 * kLength / kHandle; }

}  // namespace

Vec3 scaleFoot(const Aabb& organ, const Vec3& towardsCamera) {
  constexpr double kStep = std::numbers::pi / 18;
  const double turn = kStep * std::round(std::atan2(towardsCamera.x(), towardsCamera.z()) / kStep);
  const Vec3 away(-std::sin(turn), 0, -std::cos(turn));
  const Vec3 left = Vec3::UnitY().cross(away), half = 0.5 * organ.size();
  const auto reach = [&](const Vec3& way) { return way.cwiseAbs().dot(half); };
  Vec3 foot = organ.centre() + (reach(left) + 0.06) * left + 0.5 * reach(away) * away;
  foot.y() = 0;
  return foot;
}

IsoDragger::IsoDragger(SoSeparator* parent, const Vec3& foot) : parent_(parent), foot_(foot) {
  root_ = new SoSwitch;
  root_->whichChild = 0;
  auto* scale = new SoSeparator;
  scale->renderCaching = SoSeparator::OFF;
  root_->addChild(scale);
  scale->addChild(place_ = new SoTransform);

  auto* ruler = new SoSeparator;
  auto* colour = new SoBaseColor;
  colour->rgb.setValue(0.62f, 0.72f, 0.76f);
  auto* style = new SoDrawStyle;
  style->lineWidth = 2;
  auto* points = new SoCoordinate3;
  int count = 0;
  points->point.set1Value(count++, 0, 0, 0);
  points->point.set1Value(count++, 0, kLength, 0);
  auto* lines = new SoLineSet;
  lines->numVertices.set1Value(0, 2);
  for (int tick = 0; tick <= 10; ++tick) {
    const float y = kLength * float(tick) / 10, half = tick % 5 == 0 ? 0.009f : 0.005f;
    points->point.set1Value(count++, -half, y, 0);
    points->point.set1Value(count++, half, y, 0);
    lines->numVertices.set1Value(tick + 1, 2);
  }
  ruler->addChild(colour);
  ruler->addChild(style);
  ruler->addChild(points);
  ruler->addChild(lines);
  scale->addChild(ruler);

  auto* label = new SoSeparator;
  auto* above = new SoTranslation;
  above->translation.setValue(0, kLength + 0.012f, 0);
  // Sized in scene units, not pixels, so that it looks the same on every screen and at reduced
  // resolution.
  auto* facing = new SoVRMLBillboard;
  facing->axisOfRotation.setValue(0, 0, 0);
  auto* font = new SoFont;
  font->size = 0.018f;
  auto* flat = new SoLightModel;
  flat->model = SoLightModel::BASE_COLOR;
  auto* ink = new SoBaseColor;
  ink->rgb.setValue(0.92f, 0.96f, 0.97f);
  text_ = new SoText3;
  text_->justification = SoText3::CENTER;
  label->addChild(above);
  label->addChild(facing);
  for (SoNode* node : std::initializer_list<SoNode*>{font, flat, ink, text_})
    facing->addChild(node);
  scale->addChild(label);

  auto* upright = new SoTransform;
  upright->rotation.setValue(SbVec3f(0, 0, 1), float(std::numbers::pi / 2));
  upright->scaleFactor.setValue(kHandle, kHandle, kHandle);
  dragger_ = new SoTranslate1Dragger;
  dragger_->addValueChangedCallback(dragged, this);
  scale->addChild(upright);
  scale->addChild(dragger_);
  parent_->addChild(root_);
  moveTo(foot);
  write();
}

IsoDragger::~IsoDragger() {
  dragger_->removeValueChangedCallback(dragged, this);
  parent_->removeChild(root_);
}

void IsoDragger::show(bool shown) { root_->whichChild = shown ? 0 : SO_SWITCH_NONE; }

bool IsoDragger::shown() const { return root_->whichChild.getValue() == 0; }

void IsoDragger::moveTo(const Vec3& foot) {
  foot_ = foot;
  place_->translation.setValue(float(foot.x()), float(foot.y()), float(foot.z()));
}

Vec3 IsoDragger::handle() const { return foot_ + Vec3(0, value_ / 100 * kLength, 0); }

void IsoDragger::setValue(float iso) {
  value_ = std::clamp(iso, float(kMinIso), float(kMaxIso));
  write();
}

void IsoDragger::write() {
  writing_ = true;
  dragger_->translation.setValue(toDragger(value_), 0, 0);
  writing_ = false;
  text_->string = fmt::format("iso {:.0f}", value_).c_str();
}

void IsoDragger::dragged(void* closure, SoDragger*) {
  auto* self = static_cast<IsoDragger*>(closure);
  if (self->writing_) return;
  const float at = self->dragger_->translation.getValue()[0];
  // Rounded to integers, so that values are easy to read and repeat.
  self->setValue(std::round(at * kHandle / kLength * 100));
  if (self->changed) self->changed(self->value_);
}

}  // namespace resect

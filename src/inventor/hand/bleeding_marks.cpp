#include "inventor/hand/bleeding_marks.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoDepthBuffer.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace resect {
namespace {

constexpr int kCorners = 20;
constexpr double kSmallest = 0.0018, kLargest = 0.005;  // m
constexpr double kFlowOfLargest = 1e-6;                 // m^3/s
constexpr double kSeen = 0.5e-3;                        // m: smaller motions are not shown

}  // namespace

BleedingMarks::BleedingMarks(SoSeparator* parent)
    : parent_(parent), root_(new SoSwitch), corners_(new SoCoordinate3), lines_(new SoLineSet) {
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  auto* through = new SoDepthBuffer;
  through->test = FALSE;
  auto* colour = new SoBaseColor;
  colour->rgb.setValue(1.0f, 0.85f, 0.2f);  // is told from blood by colour-blind people too
  auto* style = new SoDrawStyle;
  style->lineWidth = 2;
  auto* rings = new SoSeparator;
  rings->renderCaching = SoSeparator::OFF;
  for (SoNode* node :
       std::initializer_list<SoNode*>{unpickable, unlit, through, colour, style, corners_, lines_})
    rings->addChild(node);
  root_->addChild(rings);
  root_->whichChild = SO_SWITCH_NONE;
  parent_->addChild(root_);
}

BleedingMarks::~BleedingMarks() { parent_->removeChild(root_); }

Aabb BleedingMarks::hide() {
  if (shown_.empty()) return {};
  root_->whichChild = SO_SWITCH_NONE;
  shown_.clear();
  return std::exchange(box_, {});
}

Aabb BleedingMarks::show(std::span<const BleedingEnd> ends, const Vec3& towardsEye) {
  std::vector<Ring> rings;
  for (const BleedingEnd& end : ends) {
    if (end.flow < kLeastFlow) continue;
    const double share = std::min(1.0, std::cbrt(end.flow / kFlowOfLargest));
    rings.push_back({end.place, kSmallest + share * (kLargest - kSmallest)});
  }
  if (rings.empty()) return hide();
  const auto alike = [](const Ring& a, const Ring& b) {
    return (a.place - b.place).norm() < kSeen && std::abs(a.radius - b.radius) < kSeen;
  };
  if ((towardsEye - towardsEye_).norm() < 0.02 && std::ranges::equal(rings, shown_, alike))
    return {};
  towardsEye_ = towardsEye;
  const Aabb before = box_;
  box_ = {};
  const Vec3 u = towardsEye.unitOrthogonal(), v = towardsEye.cross(u);
  std::vector<SbVec3f> points;
  for (const Ring& ring : rings)
    for (int i = 0; i <= kCorners; ++i) {
      const double a = 2 * std::numbers::pi * i / kCorners;
      const Vec3 p = ring.place + ring.radius * (std::cos(a) * u + std::sin(a) * v);
      points.emplace_back(float(p.x()), float(p.y()), float(p.z()));
      box_.grow(p);
    }
  corners_->point.setNum(0);
  corners_->point.setValues(0, int(points.size()), points.data());
  const std::vector<std::int32_t> counts(rings.size(), kCorners + 1);
  lines_->numVertices.setNum(0);
  lines_->numVertices.setValues(0, int(counts.size()), counts.data());
  root_->whichChild = SO_SWITCH_ALL;
  shown_ = std::move(rings);
  box_ = box_.padded(0.003);  // lines have a width
  Aabb changed = before;
  changed.grow(box_);
  return changed;
}

}  // namespace resect

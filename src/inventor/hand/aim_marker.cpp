#include "inventor/hand/aim_marker.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace resect {
namespace {

constexpr double kLift = 0.0015;                                  // m above the surface
constexpr double kRing = 0.0035, kArrow = 0.016, kHead = 0.0035;  // m
constexpr double kDepthPerTick = 0.005;                           // m
constexpr int kRingCorners = 24;

// Lines in the plane of the surface: pairs (to the side, forwards), m.
using Line = std::vector<Eigen::Vector2d>;

std::vector<Line> linesOf(double depth) {
  Line ring;
  for (int i = 0; i <= kRingCorners; ++i) {
    const double a = 2 * std::numbers::pi * i / kRingCorners;
    ring.emplace_back(kRing * std::cos(a), kRing * std::sin(a));
  }
  std::vector<Line> lines{
      ring,
      {{0, kRing}, {0, kArrow}},
      {{-0.6 * kHead, kArrow - kHead}, {0, kArrow}, {0.6 * kHead, kArrow - kHead}}};
  const int ticks = int(std::lround(depth / kDepthPerTick));
  for (int i = 0; i < ticks; ++i) {
    const double y = -kRing - 0.002 - 0.0018 * i;
    lines.push_back({{-0.002, y}, {0.002, y}});
  }
  return lines;
}

}  // namespace

AimMarker::AimMarker(SoSeparator* parent)
    : parent_(parent),
      root_(new SoSwitch),
      colour_(new SoBaseColor),
      corners_(new SoCoordinate3),
      lines_(new SoLineSet) {
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  auto* style = new SoDrawStyle;
  style->lineWidth = 2.5f;
  auto* lines = new SoSeparator;
  lines->renderCaching = SoSeparator::OFF;
  for (SoNode* node :
       std::initializer_list<SoNode*>{unpickable, unlit, colour_, style, corners_, lines_})
    lines->addChild(node);
  root_->addChild(lines);
  root_->whichChild = SO_SWITCH_NONE;
  parent_->addChild(root_);
}

AimMarker::~AimMarker() { parent_->removeChild(root_); }

Aabb AimMarker::show(const SurfaceHand* hand) {
  const Aabb before = box_;
  if (!hand) {
    if (box_.empty()) return {};
    root_->whichChild = SO_SWITCH_NONE;
    box_ = {};
    return before;
  }
  if (!box_.empty() && workPoint(*hand) == at_ && hand->heading == heading_ && hand->up == up_ &&
      (hand->target ? 0 : hand->depth) == depth_ && hand->pressing == pressing_)
    return {};
  at_ = workPoint(*hand), heading_ = hand->heading, up_ = hand->up;
  depth_ = hand->target ? 0 : hand->depth, pressing_ = hand->pressing;
  colour_->rgb = pressing_ ? SbColor(1.0f, 0.72f, 0.25f) : SbColor(0.75f, 0.95f, 1.0f);
  const Vec3 side = heading_.cross(up_), foot = at_ + kLift * up_;
  int corner = 0, line = 0;
  box_ = {};
  const auto all = linesOf(depth_);
  corners_->point.setNum(0);
  lines_->numVertices.setNum(int(all.size()));
  for (const Line& points : all) {
    for (const Eigen::Vector2d& p : points) {
      const Vec3 world = foot + p.x() * side + p.y() * heading_;
      corners_->point.set1Value(corner++, float(world.x()), float(world.y()), float(world.z()));
      box_.grow(world);
    }
    lines_->numVertices.set1Value(line++, int(points.size()));
  }
  root_->whichChild = SO_SWITCH_ALL;
  box_ = box_.padded(0.003);  // lines have a width
  Aabb changed = before;
  changed.grow(box_);
  return changed;
}

}  // namespace resect

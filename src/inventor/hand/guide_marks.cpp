#include "inventor/hand/guide_marks.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoDepthBuffer.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "anatomy/anatomy.h"

namespace resect {
namespace {

constexpr int kCorners = 32;
constexpr double kSeen = 0.7e-3;  // m: smaller motions are not shown
constexpr double kFar = 0.03;     // m: from here on an instrument is not at the goal yet
// Told apart by colour-blind people too: blue, yellow, vermilion.
const Vec3f kNext{1.0f, 0.85f, 0.2f}, kOther{0.55f, 0.68f, 0.75f}, kWell{0.25f, 0.75f, 1.0f},
    kWrong{1.0f, 0.3f, 0.1f};

std::vector<Vec3> ring(const Vec3& middle, double radius, const Vec3& axis) {
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Vec3> points;
  for (int i = 0; i <= kCorners; ++i) {
    const double a = 2 * std::numbers::pi * i / kCorners;
    points.push_back(middle + radius * (std::cos(a) * u + std::sin(a) * v));
  }
  return points;
}

// Where the plane through p cuts the box: a closed polygon, and lines across it every 2 cm.
std::vector<std::vector<Vec3>> planeLines(const Vec3& p, const Vec3& normal, const Aabb& box) {
  constexpr double kStep = 0.02;
  const Vec3 up = (Vec3::UnitY() - Vec3::UnitY().dot(normal) * normal).norm() > 0.1
                      ? Vec3((Vec3::UnitY() - Vec3::UnitY().dot(normal) * normal).normalized())
                      : normal.unitOrthogonal();
  const Vec3 along = normal.cross(up);
  const Vec3 half = 0.5 * box.size();
  const Vec3 middle = box.centre() - (box.centre() - p).dot(normal) * normal;
  const double wide = along.cwiseAbs().dot(half), high = up.cwiseAbs().dot(half);
  std::vector<std::vector<Vec3>> lines;
  const auto at = [&](double a, double u) { return Vec3(middle + a * along + u * up); };
  lines.push_back(
      {at(-wide, -high), at(wide, -high), at(wide, high), at(-wide, high), at(-wide, -high)});
  for (double a = kStep - wide; a < wide; a += kStep) lines.push_back({at(a, -high), at(a, high)});
  return lines;
}

Vec3f colourOf(Keeping keeping) {
  switch (keeping) {
    case Keeping::Far:
      return kOther;
    case Keeping::Well:
      return kWell;
    case Keeping::Near:
      return kNext;
    case Keeping::Wrong:
      return kWrong;
  }
  return kOther;
}

}  // namespace

std::optional<double> distanceFrom(const Guide& guide, const GuidedTip& tip) {
  using enum Guide::Kind;
  if (guide.places.empty()) return {};
  switch (guide.kind) {
    case Targets:
      if (guide.next >= guide.places.size()) return {};
      return (tip.tip - guide.places[guide.next]).norm();
    case Line: {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i + 1 < guide.places.size(); ++i)
        least = std::min(least,
                         segmentDistance(tip.tip, tip.shaft, guide.places[i], guide.places[i + 1]));
      return least;
    }
    case Plane:
      return std::abs((tip.tip - guide.places[0]).dot(guide.normal));
    case Ball:
      return (tip.tip - guide.places[0]).norm() - guide.radius;
  }
  return {};
}

Keeping keepingOf(const Guide& guide, double distance) {
  if (guide.kind == Guide::Kind::Ball) {
    if (distance <= 0) return Keeping::Wrong;
    if (distance < guide.margin) return Keeping::Near;
    return distance < guide.margin + 0.01 ? Keeping::Well : Keeping::Far;
  }
  if (distance <= guide.radius) return Keeping::Well;
  if (guide.kind == Guide::Kind::Targets || distance > kFar) return Keeping::Far;
  return distance <= 2 * guide.radius ? Keeping::Near : Keeping::Wrong;
}

GuideMarks::GuideMarks(SoSeparator* parent)
    : parent_(parent),
      root_(new SoSwitch),
      colours_(new SoBaseColor),
      corners_(new SoCoordinate3),
      lines_(new SoLineSet) {
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  auto* through = new SoDepthBuffer;
  through->test = FALSE;
  auto* style = new SoDrawStyle;
  style->lineWidth = 2;
  auto* each = new SoMaterialBinding;
  each->value = SoMaterialBinding::PER_FACE;  // a line of the set
  auto* marks = new SoSeparator;
  marks->renderCaching = SoSeparator::OFF;
  for (SoNode* node : std::initializer_list<SoNode*>{unpickable, unlit, through, style, each,
                                                     colours_, corners_, lines_})
    marks->addChild(node);
  root_->addChild(marks);
  root_->whichChild = SO_SWITCH_NONE;
  parent_->addChild(root_);
}

GuideMarks::~GuideMarks() { parent_->removeChild(root_); }

Aabb GuideMarks::hide() {
  if (shown_.empty()) return {};
  root_->whichChild = SO_SWITCH_NONE;
  shown_.clear();
  return std::exchange(box_, {});
}

std::vector<GuideMarks::Stroke> GuideMarks::linesOf(const Guide& guide, Keeping keeping,
                                                    const Vec3& towardsEye) {
  using enum Guide::Kind;
  std::vector<Stroke> lines;
  const Vec3f colour = colourOf(keeping);
  if (guide.kind == Targets)
    for (std::size_t i = guide.next; i < guide.places.size(); ++i) {
      const bool next = i == guide.next;
      const Vec3f ink = !next ? kOther : keeping == Keeping::Well ? kWell : kNext;
      lines.push_back({ink, ring(guide.places[i], guide.radius, towardsEye)});
      if (next) lines.push_back({ink, ring(guide.places[i], 0.35 * guide.radius, towardsEye)});
    }
  if (guide.kind == Line) lines.push_back({keeping == Keeping::Far ? kNext : colour, guide.places});
  if (guide.kind == Plane)
    for (auto& line : planeLines(guide.places[0], guide.normal, guide.box))
      lines.push_back({colour, std::move(line)});
  if (guide.kind == Ball) {
    lines.push_back({kWrong, ring(guide.places[0], guide.radius, towardsEye)});
    for (const Vec3& axis : {towardsEye, Vec3(Vec3::UnitY())})
      lines.push_back({colour, ring(guide.places[0], guide.radius + guide.margin, axis)});
  }
  return lines;
}

Aabb GuideMarks::show(const Guide& guide, Keeping keeping, const Vec3& towardsEye) {
  std::vector<Stroke> lines = linesOf(guide, keeping, towardsEye);
  if (lines.empty()) return hide();
  const auto near = [](const Vec3& p, const Vec3& q) { return (p - q).norm() < kSeen; };
  const bool same = std::ranges::equal(lines, shown_, [&](const Stroke& a, const Stroke& b) {
    return a.colour == b.colour && std::ranges::equal(a.points, b.points, near);
  });
  if (same) return {};
  const Aabb before = box_;
  box_ = {};
  std::vector<SbVec3f> points;
  std::vector<SbColor> colours;
  std::vector<std::int32_t> counts;
  for (const Stroke& line : lines) {
    colours.emplace_back(line.colour.x(), line.colour.y(), line.colour.z());
    counts.push_back(std::int32_t(line.points.size()));
    for (const Vec3& p : line.points) {
      points.emplace_back(float(p.x()), float(p.y()), float(p.z()));
      box_.grow(p);
    }
  }
  corners_->point.setNum(0);
  corners_->point.setValues(0, int(points.size()), points.data());
  colours_->rgb.setNum(0);
  colours_->rgb.setValues(0, int(colours.size()), colours.data());
  lines_->numVertices.setNum(0);
  lines_->numVertices.setValues(0, int(counts.size()), counts.data());
  root_->whichChild = SO_SWITCH_ALL;
  shown_ = std::move(lines);
  box_ = box_.padded(0.003);  // lines have a width
  Aabb changed = before;
  changed.grow(box_);
  return changed;
}

}  // namespace resect

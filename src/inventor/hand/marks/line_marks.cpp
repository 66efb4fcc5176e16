#include "inventor/hand/marks/line_marks.h"

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
#include <numbers>

namespace resect {

std::vector<Vec3> circle(const Vec3& middle, double radius, const Vec3& axis) {
  constexpr int kCorners = 28;
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Vec3> points;
  for (int i = 0; i <= kCorners; ++i) {
    const double a = 2 * std::numbers::pi * i / kCorners;
    points.push_back(middle + radius * (std::cos(a) * u + std::sin(a) * v));
  }
  return points;
}

LineMarks::LineMarks(SoSeparator* parent, const Style& style)
    : parent_(parent),
      root_(new SoSwitch),
      colours_(new SoBaseColor),
      corners_(new SoCoordinate3),
      lines_(new SoLineSet),
      seen_(style.seen) {
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  auto* depth = new SoDepthBuffer;
  depth->test = !style.throughTissue;
  auto* width = new SoDrawStyle;
  width->lineWidth = style.width;
  auto* each = new SoMaterialBinding;
  each->value = SoMaterialBinding::PER_FACE;  // a line of the set
  auto* marks = new SoSeparator;
  marks->renderCaching = SoSeparator::OFF;
  for (SoNode* node : std::initializer_list<SoNode*>{unpickable, unlit, depth, width, each,
                                                     colours_, corners_, lines_})
    marks->addChild(node);
  root_->addChild(marks);
  root_->whichChild = SO_SWITCH_NONE;
  parent_->addChild(root_);
}

LineMarks::~LineMarks() { parent_->removeChild(root_); }

bool LineMarks::alike(const std::vector<MarkLine>& lines) const {
  const auto near = [&](const Vec3& p, const Vec3& q) { return (p - q).norm() <= seen_; };
  return std::ranges::equal(lines, shown_, [&](const MarkLine& a, const MarkLine& b) {
    return a.colour == b.colour && std::ranges::equal(a.points, b.points, near);
  });
}

Aabb LineMarks::show(std::vector<MarkLine> lines) {
  if (alike(lines)) return {};
  Aabb changed = box_;
  box_ = {};
  std::vector<SbVec3f> points;
  std::vector<SbColor> colours;
  std::vector<std::int32_t> counts;
  for (const MarkLine& line : lines) {
    colours.emplace_back(line.colour.data());
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
  root_->whichChild = lines.empty() ? SO_SWITCH_NONE : SO_SWITCH_ALL;
  shown_ = std::move(lines);
  if (!box_.empty()) box_ = box_.padded(0.003);  // lines have a width
  changed.grow(box_);
  return changed;
}

}  // namespace resect

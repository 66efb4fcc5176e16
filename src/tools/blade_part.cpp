#include "tools/blade_part.h"

#include "tools/parting.h"
#include "tools/tool.h"

namespace resect {
namespace {

// Whether the edge moves within the blade's plane and not back out of the cut. `motion`: of the
// edge's middle, in the tool's frame, m.
bool cuts(const ToolModel& tool, const Vec3& motion) {
  const Vec3 chord = (tool.edge.back() - tool.edge.front()).normalized();
  const Vec3 middle = 0.5 * (tool.edge.back() + tool.edge.front());
  // Normal of the blade: from the curvature of the edge, or, if the edge is straight, from edge and
  // centre of the mesh.
  Vec3 normal = Vec3::Zero();
  for (const Vec3& p : tool.edge) {
    const Vec3 n = chord.cross(p - tool.edge.front());
    if (n.squaredNorm() > normal.squaredNorm()) normal = n;
  }
  if (normal.norm() < 1e-6) normal = chord.cross(bounds(tool.mesh).centre() - middle);
  if (normal.norm() < 1e-9) return true;
  normal.normalize();
  Vec3 outwards = chord.cross(normal);
  if (outwards.dot(bounds(tool.mesh).centre() - middle) > 0) outwards = -outwards;
  const double across = std::abs(motion.dot(normal));
  const Vec3 along = motion - motion.dot(normal) * normal;
  return along.norm() > across && along.dot(outwards) > -0.5 * along.norm();
}

Vec3 middleOf(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / double(points.size());
}

}  // namespace

void BladePart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const ToolModel& tool = touch.model;
  const ToolWay& way = touch.way;
  if (tool.edge.empty()) return;
  const Vec3 middle = middleOf(tool.edge);
  const Vec3 motion =
      way.to.pose.inverse().rotation * (way.to.pose * middle - way.from.pose * middle);
  if (!cuts(tool, motion)) return;
  SweptBlade blade = sweepBlade(tool.edge, way.earlier.pose, way.from.pose);
  append(blade, sweepBlade(tool.edge, way.from.pose, way.to.pose));
  partAlong(touch, std::move(blade), edits);
}

}  // namespace resect

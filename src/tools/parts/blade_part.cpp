#include "tools/parts/blade_part.h"

#include "tools/parts/bare_vessels.h"
#include "tools/tool.h"

namespace resect {
namespace {

// Normal of the blade's plane, such that the edge cuts away from the blade's body.
Vec3 normalOf(const ToolModel& tool) {
  const Vec3 chord = (tool.edge.back() - tool.edge.front()).normalized();
  const Vec3 toBody = bounds(tool.mesh).centre() - 0.5 * (tool.edge.back() + tool.edge.front());
  // From the curvature of the edge, or, if the edge is straight, from edge and body.
  Vec3 normal = Vec3::Zero();
  for (const Vec3& p : tool.edge) {
    const Vec3 n = chord.cross(p - tool.edge.front());
    if (n.squaredNorm() > normal.squaredNorm()) normal = n;
  }
  constexpr double kStraight = 1e-6, kNoBody = 1e-9;  // m
  if (normal.norm() < kStraight) normal = chord.cross(toBody);
  if (normal.norm() < kNoBody) normal = chord.unitOrthogonal();
  normal.normalize();
  return chord.cross(normal).dot(toBody) > 0 ? Vec3(-normal) : normal;
}

}  // namespace

void BladePart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  if (touch.model.edge.size() < 2 || touch.organ.vessels.bared.empty()) return;
  divideBareVessels(touch, sweepBlade(touch.model.edge, touch.way.from.pose, touch.way.to.pose),
                    edits);
}

void BladePart::addEdges(const ToolModel& tool, const ToolWay& way,
                         std::vector<CuttingEdge>& edges) const {
  if (tool.edge.size() < 2) return;
  edges.push_back({tool.edge, normalOf(tool), way.from.pose, way.to.pose, tool.bluntness});
}

}  // namespace resect

#include "tools/parts/jaws_part.h"

#include "geometry/rotation.h"
#include "tools/parts/bare_vessels.h"
#include "tools/tool.h"

namespace resect {
namespace {

// Pose of one jaw, `side` 1 or -1: of the tool's coordinates with the jaw closed.
Pose jawPose(const Jaws& jaws, const ToolStance& at, double side) {
  const Eigen::Quaterniond turn =
      rotationAbout(jaws.axis, side * 0.5 * (1 - at.squeeze) * jaws.opening);
  return {at.pose * (jaws.pivot - turn * jaws.pivot), at.pose.rotation * turn};
}

}  // namespace

void JawsPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const bool closes = touch.way.to.squeeze > touch.way.from.squeeze;
  if (!closes || touch.model.edge.size() < 2 || touch.organ.vessels.bared.empty()) return;
  for (const double side : {1.0, -1.0})
    divideBareVessels(touch,
                      sweepBlade(touch.model.edge, jawPose(touch.model.jaws, touch.way.from, side),
                                 jawPose(touch.model.jaws, touch.way.to, side)),
                      edits);
}

void JawsPart::addEdges(const ToolModel& tool, const ToolWay& way,
                        std::vector<CuttingEdge>& edges) const {
  const Jaws& jaws = tool.jaws;
  if (tool.edge.size() < 2 || !(jaws.opening > 0)) return;
  const double before = way.from.squeeze, now = way.to.squeeze;
  if (before == 1 && now == 1) return;
  const Vec3 chord = tool.edge.back() - tool.edge.front();
  const Vec3 middle = 0.5 * (tool.edge.back() + tool.edge.front());
  // Towards which side of the edges the jaw of side -1 closes.
  const Vec3 closing = jaws.axis.cross(middle - jaws.pivot);
  const double sign = chord.cross(jaws.axis).dot(closing) > 0 ? 1 : -1;
  for (const double side : {1.0, -1.0})
    edges.push_back({tool.edge, -side * sign * jaws.axis, jawPose(jaws, way.from, side),
                     jawPose(jaws, way.to, side), tool.bluntness, side<0, now> before});
}

}  // namespace resect

#include "tools/jaws_part.h"

#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "tools/parting.h"
#include "tools/tool.h"

namespace resect {
namespace {

// One edge of the jaws, `side` 1 or -1, in the world; from tip to heel for one, reversed for the
// other, so that both sweeps have the same normal where they meet.
std::vector<Vec3> jawEdge(const ToolModel& tool, const ToolStance& at, double side) {
  const Eigen::Quaterniond turn =
      rotationAbout(tool.jaws.axis, side * 0.5 * (1 - at.squeeze) * tool.jaws.opening);
  std::vector<Vec3> edge;
  for (const Vec3& p : tool.edge)
    edge.push_back(at.pose * (tool.jaws.pivot + turn * (p - tool.jaws.pivot)));
  if (side < 0) std::reverse(edge.begin(), edge.end());
  return edge;
}

// The sweep of the edges of closing jaws; empty while they open.
SweptBlade sweepOfJaws(const ToolModel& tool, const ToolStance& from, const ToolStance& to) {
  constexpr double kStep = 0.06;  // rad: an edge of 40 mm deviates 0.02 mm from its arc
  SweptBlade blade;
  if (!(to.squeeze > from.squeeze)) return blade;
  const double angle = 0.5 * (to.squeeze - from.squeeze) * tool.jaws.opening;
  const int steps = std::max(1, int(std::ceil(angle / kStep)));
  for (const double side : {1.0, -1.0}) {
    std::vector<Vec3> before = jawEdge(tool, from, side);
    for (int k = 1; k <= steps; ++k) {
      const double share = double(k) / steps;
      const std::vector<Vec3> after = jawEdge(tool,
                                              {interpolate(from.pose, to.pose, share),
                                               from.squeeze + share * (to.squeeze - from.squeeze)},
                                              side);
      append(blade, ruledBlade(before, after));
      before = after;
    }
  }
  return blade;
}

}  // namespace

void JawsPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const ToolModel& tool = touch.model;
  if (tool.edge.empty() || !(tool.jaws.opening > 0)) return;
  SweptBlade blade = sweepOfJaws(tool, touch.way.from, touch.way.to);
  if (blade.empty()) return;
  append(blade, sweepOfJaws(tool, touch.way.earlier, touch.way.from));
  partAlong(touch, std::move(blade), edits);
}

}  // namespace resect

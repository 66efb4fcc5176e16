#include "tools/parts/hook_part.h"

#include <algorithm>
#include <cmath>

#include "geometry/moved_box.h"
#include "tools/tool.h"

namespace resect {
namespace {

// The circle of a hook's bend, in the tool's frame.
struct Bend {
  Vec3 centre, normal;
  double radius = 0;

  explicit Bend(const std::vector<Vec3>& line)
      : centre(0.5 * (line.front() + line.back())),
        normal((line.front() - centre).cross(line[line.size() / 2] - centre).normalized()) {
    for (const Vec3& p : line) radius = std::max(radius, (p - centre).norm());
  }
  // Whether p is in the circle or less than a cell away.
  bool holds(const Vec3& p, double spacing) const {
    const double off = (p - centre).dot(normal);
    return std::abs(off) < spacing && (p - centre - off * normal).norm() < radius + 0.5 * spacing;
  }
};

}  // namespace

void HookPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const ToolModel& tool = touch.model;
  if (tool.hook.empty() || touch.tissue.gripped(touch.tool) > 0) return;
  const Pose &from = touch.way.from.pose, &to = touch.way.to.pose, toTool = to.inverse();
  const Vec3 motion = toTool.rotation * (to.position - from.position);
  if (!(motion.norm() > 0 && motion.dot(tool.axis) > 0.2 * motion.norm())) return;

  const Lattice& lattice = touch.organ.rest.lattice;
  const double spacing = lattice.spacing.x();
  const Bend bend(tool.hook);
  const Aabb box = Aabb{bend.centre, bend.centre}.padded(bend.radius + spacing);
  for (const std::int64_t c : touch.tissue.cellsIn(movedBox(box, to))) {
    if (!touch.organ.alive[std::size_t(c)]) continue;
    const Vec3 x = lattice.centre(lattice.cell(c)) + touch.tissue.displacement(c);
    if (bend.holds(toTool * x, spacing)) edits.push_back(touch.edit(Grip{c, from}));
  }
}

}  // namespace resect

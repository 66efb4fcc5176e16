#include "tools/parts/grasp_part.h"

#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kCloses = 0.9;        // squeeze from which the tips hold
constexpr double kOpens = 0.7;         // squeeze below which they no longer do
constexpr double kGraspReach = 0.004;  // m: what is so near to the tips is between them

}  // namespace

void GraspPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const ToolStance &from = touch.way.from, &to = touch.way.to;
  const bool holds = touch.tissue.gripped(touch.tool) > 0;
  if (holds && to.squeeze < kOpens) edits.push_back(touch.edit(Release{}));
  if (holds || to.squeeze < kCloses || from.squeeze >= kCloses) return;

  const Lattice& lattice = touch.organ.rest.lattice;
  // The outermost centres of cells lie about half a cell below the surface that the tips are on.
  const double reach = kGraspReach + 0.6 * lattice.spacing.x();
  const Vec3 tip = to.pose * touch.model.tip;
  for (const std::int64_t c : touch.tissue.cellsIn(Aabb{tip, tip}.padded(reach))) {
    if (!touch.organ.alive[std::size_t(c)]) continue;
    const Vec3 x = lattice.centre(lattice.cell(c)) + touch.tissue.displacement(c);
    if ((x - tip).norm() < reach) edits.push_back(touch.edit(Grip{c, from.pose}));
  }
}

}  // namespace resect

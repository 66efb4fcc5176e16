#include "tools/parting.h"

#include "tissue/stencil.h"

namespace resect {

void append(SweptBlade& blade, const SweptBlade& more) {
  blade.triangles.insert(blade.triangles.end(), more.triangles.begin(), more.triangles.end());
  blade.bounds.grow(more.bounds);
}

void partAlong(const Touch& touch, SweptBlade blade, std::vector<TissueEdit>& edits) {
  if (blade.empty()) return;
  const Lattice& lattice = touch.organ.rest.lattice;
  const TissueModel& tissue = touch.tissue;
  std::vector<std::int64_t> near;
  std::vector<SeverBond> crossed;
  for (const std::int64_t c : tissue.cellsIn(blade.bounds.padded(2 * lattice.spacing.x()))) {
    if (!touch.organ.alive[std::size_t(c)]) continue;
    near.push_back(c);
    const Vec3i at = lattice.cell(c);
    const Vec3 x = lattice.centre(at) + tissue.displacement(c);
    const std::uint32_t bonds = tissue.bonds(c);
    for (int d = kFirstForward; d < kDirections; ++d) {
      if (!(bonds >> d & 1)) continue;
      const Vec3i other = at + offsetOf(d);
      const Vec3 y = lattice.centre(other) + tissue.displacement(lattice.index(other));
      if (crossing(blade, x, y)) crossed.push_back({c, d});
    }
  }
  if (near.empty()) return;
  edits.push_back(touch.edit(Incision{std::move(blade), std::move(near)}));
  for (const SeverBond& bond : crossed) edits.push_back(touch.edit(bond));
}

}  // namespace resect

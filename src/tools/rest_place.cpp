#include "tools/rest_place.h"

#include <cmath>

#include "organ/vertex_labels.h"

namespace resect {

std::optional<Vec3> restPlace(const Organ& organ, const TissueModel& tissue, const Vec3& world) {
  const Lattice& lattice = organ.rest.lattice;
  Aabb box;
  box.grow(world);
  std::int64_t best = -1;
  double least = 0;
  for (const std::int64_t cell : tissue.cellsIn(box.padded(2 * lattice.spacing.x()))) {
    if (!organ.alive[std::size_t(cell)]) continue;
    const Vec3 x = lattice.centre(lattice.cell(cell)) + tissue.displacement(cell);
    const double d = (x - world).squaredNorm();
    if (best < 0 || d < least) least = d, best = cell;
  }
  if (best < 0) return {};
  const Vec3 rest = lattice.centre(lattice.cell(best));
  const Mat3 f = tissue.deformation(best);
  const Vec3 away = world - rest - tissue.displacement(best);
  return rest + (std::abs(f.determinant()) > 0.1 ? Vec3(f.inverse() * away) : away);
}

Vec3 presentPlace(const Organ& organ, const TissueModel& tissue, const Vec3& rest) {
  const Lattice& lattice = organ.rest.lattice;
  const std::int64_t cell = nearestParticle(lattice, organ.alive, rest);
  if (cell < 0) return rest;
  const Vec3 centre = lattice.centre(lattice.cell(cell));
  return centre + tissue.displacement(cell) + tissue.deformation(cell) * (rest - centre);
}

}  // namespace resect

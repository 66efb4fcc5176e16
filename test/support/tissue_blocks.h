// Simple bodies for the tests of tissue.
#pragma once

#include "base/random.h"
#include "tissue/elastic/elastic_tissue.h"

namespace resect::test {

inline constexpr double kFrame = 1.0 / 60;  // duration of a frame, s

// A box of solid cells; cell (0, 0, 0) is centred at the origin.
inline TissueCells solidBlock(const Vec3i& dims, double spacing, const TissueMaterial& material) {
  TissueCells cells;
  cells.lattice.spacing = Vec3::Constant(spacing);
  cells.lattice.dims = dims;
  cells.solid.assign(cells.lattice.cellCount(), 1);
  cells.materials = {material};
  return cells;
}

inline TissueMaterial material(double young, double poisson, double density = 1000) {
  TissueMaterial m;
  m.young = young;
  m.poisson = poisson;
  m.density = density;
  return m;
}

// Liver without stiffening and Maxwell branches.
inline TissueMaterial plainLiver() {
  TissueMaterial m = liverTissue();
  m.stiffening = 0;
  m.branches.clear();
  return m;
}

inline TissueSettings weightless() {
  TissueSettings settings;
  settings.gravity = Vec3::Zero();
  return settings;
}

// visit(cell number, lattice coordinates) for all solid cells.
template <typename Visit>
void forEachCell(const ElasticTissue& tissue, Visit visit) {
  for (std::int64_t c = 0; c < tissue.lattice().cellCount(); ++c)
    if (tissue.solid(c)) visit(c, tissue.lattice().cell(c));
}

// The same for all cells with tissue, boundary cells too.
template <typename Visit>
void forEachSolid(const ElasticTissue& tissue, Visit visit) {
  for (std::int64_t c = 0; c < tissue.lattice().cellCount(); ++c)
    if (tissue.state().solid[tissue.state().box.fromLattice(c)]) visit(c, tissue.lattice().cell(c));
}

// Severs all bonds between cells that `side` puts on different sides.
template <typename Side>
void severBetween(ElasticTissue& tissue, Side side) {
  forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    for (int d = 0; d < kDirections; ++d)
      if (tissue.bonds(c) >> d & 1 && side(at) != side(Vec3i(at + offsetOf(d)))) tissue.sever(c, d);
  });
}

}  // namespace resect::test

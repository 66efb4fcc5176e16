// Boundary cells of elastic tissue: cells whose centres lie outside the organ, but which hold some
// of its tissue. Without them, parts of the organ that lie oblique in the lattice end in stairs of
// whole cells. The steps bear no stress, so a beam that is 4 cells thick and turned by 30 degrees
// would bend by 1.5 times what it should (docs/methods/tissue.md, "Boundary cells").
//
// A boundary cell has a displacement, a velocity and bonds like any cell. Each boundary cell
// belongs to a particle, a cell whose centre is inside the organ. Edits concern particles only, and
// the boundary follows: a boundary cell goes with its particle, and a bond of a boundary cell lives
// as long as bonds of particles connect the same places. Cells are given by their index in the
// CellBox, except in holdsTissue() and stressShares().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"
#include "tissue/material.h"

namespace resect {

// Whether a cell of the lattice is a particle, or a boundary cell that is at least a tenth full.
bool holdsTissue(const TissueCells& cells, std::int64_t cell);

// Per cell of the lattice: the volume, in volumes of a cell, that stresses at the cell's centre act
// on. The tissue of a cell that is only filled in part lies beside the cell's centre. So it counts
// for this cell and for neighbours, in such shares that moments of the volume are kept: otherwise a
// boundary cell would have too long a lever in bending. The sum over all cells is the organ's
// volume, if each cell with tissue has a neighbour that holdsTissue(). Without TissueCells::share:
// 1 for each particle.
std::vector<float> stressShares(const TissueCells& cells);

inline bool isParticle(const ElasticState& s, std::int32_t i) { return s.solid[i] && !s.owner[i]; }
// The particle that a solid cell belongs to; a particle belongs to itself.
inline std::int32_t ownerOf(const ElasticState& s, std::int32_t i) {
  return s.owner[i] ? i + s.box.step[s.owner[i] - 1] : i;
}
// The particle and the boundary cells that belong to it.
std::vector<std::int32_t> withBoundary(const ElasticState& s, std::int32_t particle);
// The bonds of a particle to other particles; 0 for a boundary cell.
std::uint32_t particleBonds(const ElasticState& s, std::int32_t i);

// Whether two neighbouring cells are connected by bonds of particles: if both belong to the same
// particle, if their particles are bonded, or if both of their particles are bonded to a third.
bool connected(const ElasticState& s, std::int32_t i, std::int32_t j);

// Severs the bonds of boundary cells near these cells that are connected() no longer. Call after
// bonds of particles were severed. Appends the cells whose bonds were severed to `changed`.
void severBoundaryBonds(ElasticState& s, std::vector<std::int32_t>& changed);

// The boundary cells among `cells` that have too few bonds for a gradient. They hold a little
// tissue in a place that is too thin for it, and nothing but single bonds would carry them: remove
// them.
std::vector<std::int32_t> thinBoundary(const ElasticState& s, std::span<const std::int32_t> cells);

}  // namespace resect

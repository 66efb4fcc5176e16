// Still tissue for tests of bleeding, and a cut through the vein that runs along x in it.
#pragma once

#include "anatomy/small_vessels.h"
#include "simulation/simulation.h"
#include "support/block_organ.h"

namespace resect::test {

// The cells of a block of 60 x 30 x 60 mm that lies `height`, m, over the table.
inline Discretization veinBlock(double height = 0) {
  constexpr double kSide = 0.005;  // m
  Discretization cells = fullBlock({12, 6, 12}, kSide);
  cells.lattice.origin = Vec3(0.5 * kSide, height + 0.5 * kSide, 0.5 * kSide);
  return cells;
}

// Cuts down through the top of such a block and across the vein.
inline TissueEdit cutAcrossVein(double height = 0) {
  return {0, -1, Incision{acrossX(0.0321, height + 0.01, height + 0.05)}};
}

}  // namespace resect::test

// Conditions under which elastic tissue tears: docs/methods/tissue.md, "Tearing". A further
// constant of these conditions, kTearLength, is in tissue/material.h.
#pragma once

#include "base/vec.h"

namespace resect {

// Let e be the energy per volume of the cell at the tip of a crack. The crack advances if e times
// the spacing (side of a cell), divided by the tear energy (TissueMaterial::tearEnergy), reaches
// this value. The value was measured in notched strips with cells of 2.5 to 8 mm, on lattices that
// were aligned with the strip and on rotated lattices (test/tissue/tear_energy_test.cpp).
inline constexpr double kCrackShare = 0.28;
// Greatest speed of a crack, m/s. A crack also advances by at most one cell in a frame.
inline constexpr double kTearSpeed = 0.3;
// Tissue without a crack tears only near grips: inside the bounding box of all gripped cells at
// rest, enlarged by this length on all sides, m. The length is rounded to whole cells, and is at
// least one cell.
inline constexpr double kGripReach = 0.02;
// To save time, a cell at a cut and the cells bonded to it are examined only if the energy per
// volume of the cell at the cut is high enough. This energy must be at least this share of the
// energy per volume at which a crack advances in the weakest material.
inline constexpr double kScreen = 0.3;
// Two cells, or two bonds, count as equally loaded if the lower of their energies per volume is at
// least this share of the higher. So all bonds along the front of a crack tear in the same frame,
// even if rounding makes their energies differ.
inline constexpr double kAlike = 0.9;

// Direction in rest space in which the deformation gradient F stretches most, unit.
Vec3 mostStretched(const Mat3& f);

}  // namespace resect

// Conditions under which elastic tissue tears: docs/methods/tissue.md, "Tearing". A further
// constant of these conditions, kTearLength, is in tissue/material.h.
#pragma once

#include "base/vec.h"

namespace resect {

// A crack advances if the energy per volume of the cell at its tip, times the spacing, divided by
// the tear energy, reaches this value. Measured in notched strips with cells of 2.5 to 8 mm, on
// lattices aligned with the strip and rotated (test/tissue/tear_energy_test.cpp).
inline constexpr double kCrackShare = 0.28;
// Greatest speed of a crack, m/s. A crack also advances by at most one cell in a frame.
inline constexpr double kTearSpeed = 0.3;
// How far from a gripped cell tissue without a crack may tear, m.
inline constexpr double kGripReach = 0.02;
// A cell at a cut and the cells bonded to it become candidates for a tear when the cell's energy
// per volume is at least this share of the one at which the weakest material tears at a crack.
inline constexpr double kScreen = 0.3;
// Two cells, or two bonds, count as equally loaded if the lower energy is at least this share of
// the higher. So bonds along a crack's front tear in the same frame, even if rounding makes their
// energies differ.
inline constexpr double kAlike = 0.9;

// Unit vector of rest space along which F stretches most.
Vec3 mostStretched(const Mat3& f);

}  // namespace resect

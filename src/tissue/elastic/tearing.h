// When elastic tissue tears: docs/methods/tissue.md, "Tearing". kTearLength is in
// tissue/material.h.
#pragma once

#include "base/vec.h"

namespace resect {

// Energy per volume of the cell at the tip of a crack that advances, times the spacing, divided by
// the tear energy. Measured in notched strips on cells of 2.5 to 8 mm, aligned and turned
// (test/tissue/tear_energy_test.cpp).
inline constexpr double kCrackShare = 0.28;
// Largest speed of a crack, m/s. It also advances by at most one cell in a frame.
inline constexpr double kTearSpeed = 0.3;
// How far from a gripped cell tissue without a crack may tear, m.
inline constexpr double kGripReach = 0.02;
// A cell at a cut, with its neighbours, becomes a candidate when it holds this share of the energy
// that tears the weakest material.
inline constexpr double kScreen = 0.3;
// Cells and bonds count as equal if their energies differ by no more than this factor. So those
// along a crack's front tear in the same frame, even if rounding makes their energies differ.
inline constexpr double kAlike = 0.9;

// Unit vector of rest space along which F stretches most.
Vec3 mostStretched(const Mat3& f);

}  // namespace resect

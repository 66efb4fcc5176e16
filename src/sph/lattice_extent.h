// The spacing of a lattice that is given by two corners and its cell counts.
//
// The thesis's text file holds a lattice as two corners and the cell counts, not its spacing.
// Dividing gives 0.0049999999999999992 where 0.005 was meant; the result here is the number with
// the fewest digits that leads from the first corner to the last, bit for bit. A lattice with such
// a spacing (settled) is restored exactly from a text file.
#pragma once

#include "sph/lattice.h"

namespace resect {

// The far corner of the lattice as written to a text file: origin + dims * spacing, m.
Vec3 farCorner(const Lattice& lattice);

// Spacing per axis of `dims` > 0 cells from `first` to `last`, m; the same number on all axes
// whenever one number fits all of them. Finite corners, first < last.
Vec3 spacingBetween(const Vec3& first, const Vec3& last, const Vec3i& dims);

// The lattice with its spacing replaced by spacingBetween() of its corners (a change in the last
// bits).
Lattice settled(Lattice lattice);

}  // namespace resect

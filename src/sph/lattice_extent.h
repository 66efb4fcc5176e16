// The spacing of a lattice that is given by two corners and its cell counts.
//
// The thesis's text file holds a lattice as two corners and the cell counts, not its spacing. The
// extent divided by the count can be 0.0049999999999999992 where 0.005 was meant. spacingBetween()
// gives the number with the fewest digits that leads from the first corner to the last, bit for
// bit. A lattice with such a spacing (see settled()) is restored exactly from a text file.
#pragma once

#include "sph/lattice.h"

namespace resect {

// The far corner of the lattice as written to a text file: origin + dims * spacing, m.
Vec3 farCorner(const Lattice& lattice);

// The spacing along each axis, m, of `dims` cells from corner `first` to corner `last`. It is the
// same number on all axes whenever one number fits all of them. Corners must be finite, first <
// last and dims > 0.
Vec3 spacingBetween(const Vec3& first, const Vec3& last, const Vec3i& dims);

// The lattice with its spacing replaced by spacingBetween(origin, farCorner(lattice), dims). Only
// the last bits of the spacing change.
Lattice settled(Lattice lattice);

}  // namespace resect

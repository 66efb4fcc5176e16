// The spacing of a lattice that is given by two corners and by its number of cells along each axis.
//
// A .dis file is a text file in the format of the diploma thesis that Resect continues. It holds
// two corners of a lattice and the numbers of cells, not the spacing. The distance of the corners
// divided by the number of cells can be 0.0049999999999999992 where 0.005 was meant. Therefore
// spacingBetween() gives the number with the fewest digits that leads exactly from the first corner
// to the last. settled() gives a lattice this spacing. Then the lattice can be restored exactly
// from the text file.
#pragma once

#include "sph/lattice.h"

namespace resect {

// The far corner of the lattice as written to a text file: origin + dims * spacing, m.
Vec3 farCorner(const Lattice& lattice);

// The spacing along each axis, m, of `dims` cells from corner `first` to corner `last`. A number
// fits an axis if, along this axis, first + dims * number == last holds in floating-point
// arithmetic. If one number fits all three axes, it is the spacing along each axis. If no number
// fits an axis, the spacing along this axis is the distance divided by the number of cells. Corners
// must be finite; first < last and dims > 0 must hold on each axis.
Vec3 spacingBetween(const Vec3& first, const Vec3& last, const Vec3i& dims);

// The lattice with its spacing replaced by spacingBetween(origin, farCorner(lattice), dims). This
// changes only the last bits of the spacing. A lattice without cells is returned unchanged.
Lattice settled(Lattice lattice);

}  // namespace resect

// Fits colour values so that the organ's iso surface lies on the mesh that it was made from.
//
// The iso surface is where the colour field is 50. The field at a point is a kernel-weighted sum of
// the colour values of the cells near the point (sph/colour_field.h).
//
// If a cell's colour value were simply its share of tissue, the iso surface would deviate from the
// mesh by up to a twentieth of a cell. The deviations would be ripples that follow the lattice and
// show in highlights. Here the values of the cells that the surface crosses are corrected until the
// field is nearly 50 on the mesh. The method is simultaneous iterative reconstruction (Gilbert
// 1972). The misfit of a point on the mesh is 50 minus the field there. In each round the value of
// a cell changes in proportion to the kernel-weighted mean misfit of the points near the cell. On a
// ball the height of the ripples falls to two fifths and the error of the normals to two thirds
// (docs/methods/colour_field_and_surface.md).
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "sph/discretization.h"

namespace resect {

// Changes only values that are above 0 and below 100, and keeps them in that range. So no cell
// becomes empty or full, and no empty cell gets tissue. cells.skinScale is set to the value with
// which the sum of the cells' volumes is the same as before the fit. At the end the values are
// rounded to whole levels (sph/colour_values.h), which moves the surface by about a thousandth of a
// cell. `mesh`: the mesh that `cells` were made from. The result has the same bits at any number of
// threads. On average, the mesh has two points (pointsToFit()) on an area as large as a cell's
// face. The field at a point depends on 33 cells. Cost per point: 13 loops over these cells, and 12
// bytes of memory for each of them until the function returns.
void fitSurface(const TriangleMesh& mesh, Discretization& cells);

// The points on the mesh at which the field is fitted to 50, in cell space
// (Lattice::toCellSpace()). Every triangle gets points in proportion to its area. Within a triangle
// the points follow the additive recurrence of the plastic number (Roberts 2018), which spreads
// them evenly.
std::vector<Vec3> pointsToFit(const TriangleMesh& mesh, const Lattice& lattice);

}  // namespace resect

// Fits colour values so that the organ's iso surface lies on the mesh that it was made from.
//
// If a cell's colour value were simply its share of tissue, the iso surface would deviate from the
// mesh by up to a twentieth of a cell, in ripples that follow the lattice and show in highlights.
// Here the values of the cells that the surface crosses are corrected until the field is 50 on the
// mesh, by simultaneous iterative reconstruction (Gilbert 1972): in each round a cell's value is
// changed in proportion to the mean misfit (50 less the field) of the mesh points near it, weighted
// by the kernel. On a ball the ripples fall to two fifths and the error of normals to two thirds;
// docs/methods/colour_field_and_surface.md has the figures.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "sph/discretization.h"

namespace resect {

// Changes only values strictly between 0 and 100 and keeps them there, so no cell becomes empty or
// full, and no empty cell gets tissue. skinScale is set so that the sum of the cells' volumes stays
// the same. Values are rounded to whole levels at the end (sph/colour_values.h), which moves the
// surface by about a thousandth of a cell. `mesh`: the mesh that `cells` were made from. Same bits
// at any number of threads. Cost: two points for every cell-sized piece of the surface; for each
// point 13 loops over the 33 cells in its reach, and 12 bytes per such cell while it runs.
void fitSurface(const TriangleMesh& mesh, Discretization& cells);

// The points on the mesh at which the field is brought to 50, in cell space
// (Lattice::toCellSpace()). Every triangle gets points in proportion to its area. Within it their
// positions follow the additive recurrence of the plastic number (Roberts 2018), which spreads them
// evenly.
std::vector<Vec3> pointsToFit(const TriangleMesh& mesh, const Lattice& lattice);

}  // namespace resect

// Fits colour values so that the organ's iso surface lies on the mesh that it was made from.
//
// With each cell's share of tissue as its colour value the iso surface deviates from the body's by
// up to a twentieth of a cell, in ripples that follow the lattice and show in highlights. Here the
// values of the cells that the surface crosses are corrected until the field is 50 on it, by
// simultaneous iterative reconstruction (Gilbert 1972): each cell is changed by the mean misfit of
// the surface points near it, weighted by the kernel. On a ball the ripples fall to two fifths, the
// error of normals to two thirds; docs/methods/colour_field_and_surface.md has the figures.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "sph/discretization.h"

namespace resect {

// Changes only values strictly between 0 and 100, and keeps them there, so no cell becomes empty,
// full or tissue; skinScale keeps the sum of the cells' volumes. Finally values are rounded to
// whole levels (sph/colour_values.h), which moves the surface by about a thousandth of a cell.
// `mesh`: the mesh that `cells` were made from. Same bits at any number of threads. Cost: two
// points for every cell-sized piece of the surface; for each point a loop over its 33 cells 13
// times, and 12 bytes for each of these cells meanwhile.
void fitSurface(const TriangleMesh& mesh, Discretization& cells);

// The points on the mesh, in cell space, at which the field is brought to 50: every triangle gets
// its share by area, inside it by the additive recurrence of the plastic number (Roberts 2018),
// which fills evenly.
std::vector<Vec3> pointsToFit(const TriangleMesh& mesh, const Lattice& lattice);

}  // namespace resect

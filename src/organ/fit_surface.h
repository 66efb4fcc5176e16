// Which colour values draw the surface that an organ came from?
//
// A cell's share of tissue is a blurred sample of the body: its colour field meets the iso level up
// to a twentieth of a cell beside the body's surface, in ripples that follow the lattice and that
// wet tissue's highlights make plain to see. Here the values of the cells that the surface passes
// through are corrected until the field is 50 on it: simultaneous iterative reconstruction (Gilbert
// 1972), each cell moved by the mean misfit of the surface points near it, weighed by the kernel.
// On a ball the ripples fall to two fifths, the error of normals to two thirds;
// docs/methods/colour_field_and_surface.md has the figures.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "sph/discretization.h"

namespace resect {

// Changes only values strictly between 0 and 100, and keeps them there, so no cell becomes or stops
// being tissue; skinScale keeps the sum of the cells' volumes. At last values are rounded to whole
// levels (sph/colour_values.h), which moves the surface by about a thousandth of a cell. `mesh`:
// what `cells` were made from. Same bits at any number of threads. Cost: for every cell-sized
// piece of the surface two points, for each point its 33 cells 13 times; 12 bytes for each of those
// while it lasts.
void fitSurface(const TriangleMesh& mesh, Discretization& cells);

// The points on the mesh, in cell space, at which the field is brought to 50: every triangle gets
// its share by area, inside it by the additive recurrence of the plastic number (Roberts 2018),
// which leaves no gaps.
std::vector<Vec3> pointsToFit(const TriangleMesh& mesh, const Lattice& lattice);

}  // namespace resect

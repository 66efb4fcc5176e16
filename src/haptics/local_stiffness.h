// Stiffness of tissue at places where an instrument touches or holds the tissue. The stiffness
// follows from the theory of contact with an elastic half-space. docs/methods/haptics.md has the
// formulas and their sources.
#pragma once

#include "tissue/material.h"

namespace resect {

// Elastic moduli of tissue for a motion that lasts a given time.
struct LocalModuli {
  double shear = 0;    // Pa
  double poisson = 0;  // Poisson's ratio nu
  double plane = 0;    // E / (1 - nu^2), where E is Young's modulus; Pa
};
// The secant moduli at the end of a motion with constant speed. time: duration of the motion,
// s, > 0.
LocalModuli moduliWithin(const TissueMaterial& material, double time);

// Stiffness, N/m, of a contact patch that is pressed into the surface (pressedStiffness()) or
// dragged along the surface (draggedStiffness()). area: area of the patch, m^2. spacing: side of a
// cell, m. The stiffness is that of a slightly larger patch, since the cells' splines (SPH kernels)
// spread the force.
double pressedStiffness(const LocalModuli& moduli, double area, double spacing);
double draggedStiffness(const LocalModuli& moduli, double area, double spacing);
// Stiffness of gripped tissue, N/m. It is the same in all directions. cells: number of gripped
// cells.
double heldStiffness(const LocalModuli& moduli, int cells, double spacing);

// Stiffness of two springs in series. a, b: stiffnesses of the springs, N/m. If a or b is 0, the
// result is 0.
inline double inSeries(double a, double b) { return a > 0 && b > 0 ? a * b / (a + b) : 0; }

}  // namespace resect

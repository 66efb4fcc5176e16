// Stiffness that an instrument meets where it touches or holds tissue, from the theory of contact
// with an elastic half-space. docs/methods/haptics.md has the formulas and their sources.
#pragma once

#include "tissue/material.h"

namespace resect {

// Elastic moduli of tissue for a motion that lasts a given time.
struct LocalModuli {
  double shear = 0;    // Pa
  double poisson = 0;  // Poisson's ratio in a motion of that duration
  double plane = 0;    // E / (1 - nu^2), Pa
};
// The secant moduli at the end of a motion at constant speed that lasts `time`, s, > 0.
LocalModuli moduliWithin(const TissueMaterial& material, double time);

// Stiffness of a contact patch of `area`, m^2, that is pressed into the surface, or dragged along
// it; N/m. spacing: side of a cell, m. The cells' splines spread the force, so the patch acts as a
// larger one.
double pressedStiffness(const LocalModuli& moduli, double area, double spacing);
double draggedStiffness(const LocalModuli& moduli, double area, double spacing);
// Stiffness of a number of gripped cells, N/m; the same in all directions.
double heldStiffness(const LocalModuli& moduli, int cells, double spacing);

// Stiffness of two springs in series; 0 if one of them is 0.
inline double inSeries(double a, double b) { return a > 0 && b > 0 ? a * b / (a + b) : 0; }

}  // namespace resect

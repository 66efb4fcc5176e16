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
// time: in which the instrument moves at an even speed, s, > 0.
LocalModuli moduliWithin(const TissueMaterial& material, double time);

// Stiffness that a patch of `area` m^2 meets when it is pressed, and when it is dragged along the
// surface; the cells' splines spread its force; N/m.
double pressedStiffness(const LocalModuli& moduli, double area, double spacing);
double draggedStiffness(const LocalModuli& moduli, double area, double spacing);
// Of a number of gripped cells; N/m in any direction.
double heldStiffness(const LocalModuli& moduli, int cells, double spacing);

// Two springs one after the other; 0 if one of them is 0.
inline double inSeries(double a, double b) { return a > 0 && b > 0 ? a * b / (a + b) : 0; }

}  // namespace resect

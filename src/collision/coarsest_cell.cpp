#include "collision/coarsest_cell.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "collision/wall_thickness.h"
#include "geometry/measures.h"

namespace resect {

double coarsestCell(const TriangleMesh& surface) {
  const double whole = wallThickness(surface).cellFor(kMostLostTissue);
  const double many = math::cbrt(volume(surface) / kFewestParticles);
  constexpr double kStep = 1e-5, kLeast = 1e-5, kMost = 0.1;  // m
  return std::clamp(kStep * std::floor(std::min(whole, many) / kStep), kLeast, kMost);
}

}  // namespace resect

#include "collision/coarsest_cell.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "collision/wall_thickness.h"
#include "geometry/measures.h"

namespace resect {
namespace {

double wholeSteps(double side) {
  constexpr double kStep = 1e-5, kLeast = 1e-5, kMost = 0.1;  // m
  return std::clamp(kStep * std::floor(side / kStep), kLeast, kMost);
}

double cellOfMany(const TriangleMesh& surface) {
  return math::cbrt(volume(surface) / kFewestParticles);
}

}  // namespace

double coarsestCell(const TriangleMesh& surface) {
  return wholeSteps(std::min(wallThickness(surface).cellFor(kMostLostTissue), cellOfMany(surface)));
}

double coarsestCellOfMany(const TriangleMesh& surface) { return wholeSteps(cellOfMany(surface)); }

}  // namespace resect

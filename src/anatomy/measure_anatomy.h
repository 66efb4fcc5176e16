// Measures of vessels: sizes, and whether any leaves the organ or meets another.
#pragma once

#include <array>
#include <vector>

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"

namespace resect {

struct VesselMeasures {
  std::int32_t segments = 0, terminals = 0;
  double volume = 0;                  // of the lumina, m^3
  double length = 0;                  // m
  std::vector<double> radiusByOrder;  // mean radius per Strahler order, from the leaves, m
  double outside = 0;  // length outside the organ, without the stems that enter it, m
};

struct AnatomyMeasures {
  std::array<VesselMeasures, kVesselKinds> kinds;
  // Pairs of segments of two kinds that share a place, and the least gap between them, m. Stems
  // outside the organ are left out.
  std::array<std::array<int, kVesselKinds>, kVesselKinds> crossings{};
  std::array<std::array<double, kVesselKinds>, kVesselKinds> gaps{};
};

// `surface`: of the organ, closed, oriented outwards, in the place of the anatomy.
AnatomyMeasures measure(const Anatomy& anatomy, const TriangleMesh& surface);

}  // namespace resect

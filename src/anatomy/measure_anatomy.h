// Measures of vessels: sizes, and whether any leaves the organ or meets another.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/liver_segments.h"
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

// Volumes of Couinaud's segments I to VIII in the organ, m^3, from places 2.5 mm apart.
std::array<double, kLiverSegments> segmentVolumes(const LiverSegments& segments,
                                                  const TriangleMesh& surface);

// A vessel that has a name of its own: its first piece, and all beyond it that is called the same.
struct NamedVessel {
  std::string name;
  VesselKind kind = VesselKind::PortalVein;
  std::int32_t segment = -1;  // its first piece
  double radius = 0;          // of this, m
  std::int32_t terminals = 0;
};
// The vessels with at least `terminals` terminals, in the order of the anatomy.
std::vector<NamedVessel> namedVessels(const Anatomy& anatomy, const LiverSegments& segments,
                                      std::int32_t terminals);

}  // namespace resect

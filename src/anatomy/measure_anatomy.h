// Measures the vessels of an organ: sizes, whether any leaves the organ, and whether any meets a
// vessel of another kind.
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
  std::vector<double> radiusByOrder;  // mean radius per Strahler order, m; [0]: order 1, the leaves
  // Length along which the wall sticks out of the organ, m. Stems are not counted: a stem is the
  // piece of a vessel from its root to the place where it enters the organ.
  double outside = 0;
};

struct AnatomyMeasures {
  std::array<VesselMeasures, kVesselKinds> kinds;
  // Per pair of kinds: the number of pairs of segments that overlap, and the least gap between
  // their walls, m. A gap is negative where vessels overlap; gaps above 5 mm count as 5 mm. Stems
  // are left out.
  std::array<std::array<int, kVesselKinds>, kVesselKinds> crossings{};
  std::array<std::array<double, kVesselKinds>, kVesselKinds> gaps{};
};

// surface: of the organ; closed, oriented outwards, in the same position as the anatomy.
AnatomyMeasures measure(const Anatomy& anatomy, const TriangleMesh& surface);

// Volumes of Couinaud's segments I to VIII in the organ, m^3, computed from points 2.5 mm apart.
std::array<double, kLiverSegments> segmentVolumes(const LiverSegments& segments,
                                                  const TriangleMesh& surface);

// A vessel with a name: a segment whose parent has another name or none, and all segments after it
// in the tree that have the same name.
struct NamedVessel {
  std::string name;
  VesselKind kind = VesselKind::PortalVein;
  std::int32_t segment = -1;   // its first segment
  double radius = 0;           // of the first segment, m
  std::int32_t terminals = 0;  // in the subtree that begins with the first segment
};
// The vessels with at least `terminals` terminals, ordered as their first segments in the anatomy.
std::vector<NamedVessel> namedVessels(const Anatomy& anatomy, const LiverSegments& segments,
                                      std::int32_t terminals);

}  // namespace resect

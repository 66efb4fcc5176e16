// Measures the vessels of an organ: their sizes, the length that sticks out of the organ, and the
// gaps between vessels of different kinds.
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
  // Two measures per pair of kinds. crossings: number of pairs of segments that overlap. gaps:
  // least gap between the walls of two segments, m. A gap is negative if the segments overlap; a
  // gap above 5 mm counts as 5 mm. Stems are left out.
  std::array<std::array<int, kVesselKinds>, kVesselKinds> crossings{};
  std::array<std::array<double, kVesselKinds>, kVesselKinds> gaps{};
};

// surface: the organ's surface, closed and oriented outwards, in the same coordinates as the
// anatomy.
AnatomyMeasures measure(const Anatomy& anatomy, const TriangleMesh& surface);

// Mean and largest distance from a point of the organ to the nearest terminal of the portal vein,
// m. A terminal is an end of the vein's tree. The points are 2.5 mm apart. Both distances are 0 if
// there is no terminal.
struct TerminalDistance {
  double mean = 0, largest = 0;
};
TerminalDistance terminalDistance(const Anatomy& anatomy, const TriangleMesh& surface);

// Volumes of Couinaud's segments I to VIII in the organ, m^3, computed from points 2.5 mm apart.
std::array<double, kLiverSegments> segmentVolumes(const LiverSegments& segments,
                                                  const TriangleMesh& surface);

// A vessel with a name: a connected set of segments that all have this name. Its first segment is a
// root, or has a parent with another name.
struct NamedVessel {
  std::string name;
  VesselKind kind = VesselKind::PortalVein;
  std::int32_t segment = -1;   // index of the first segment
  double radius = 0;           // of the first segment, m
  std::int32_t terminals = 0;  // number in the subtree that begins with the first segment
};
// Several vessels may have the same name. The result contains a vessel if it has at least
// `terminals` terminals, or if no other vessel of the same name has more terminals. The vessels are
// in the order of their first segments in the anatomy.
std::vector<NamedVessel> namedVessels(const Anatomy& anatomy, const LiverSegments& segments,
                                      std::int32_t terminals);

}  // namespace resect

// Meshes of vessels that were laid bare in a wound, for viewers: walls with their ends, and clips.
#pragma once

#include <vector>

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"
#include "surface/surface_update.h"

namespace resect {

// A smooth curve from a to b (cubic Hermite). slopeA, slopeB: derivatives at its ends, m.
struct SmoothWay {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero(), slopeA = Vec3::Zero(), slopeB = Vec3::Zero();

  Vec3 at(double share) const;         // share: 0 at a, 1 at b
  Vec3 direction(double share) const;  // unit
};

// A place where a vessel is narrowed. A clip presses the vessel flat; heat shrivels it.
struct VesselPinch {
  double share = 0;  // position, as a fraction of the segment's length
  bool byHeat = false;
};

// How the wall ends. Covered: in tissue or in another vessel. Open: cut, so that the lumen is seen.
// Sealed: shrivelled by heat.
enum class WallEnd { Covered, Open, Sealed };

// The wall of a segment of a vessel, or of a part of it.
struct VesselWall {
  VesselKind kind = VesselKind::PortalVein;
  // Radii of the lumen and of the wall's outside, m. Near the axis's ends a and b the radius of the
  // outside changes gradually to outsideA and outsideB.
  double lumen = 0, outside = 0;
  double outsideA = 0, outsideB = 0;
  SmoothWay present, rest;  // axis of the segment, in the world and in rest space
  double from = 0, to = 1;  // the wall covers the axis between these fractions
  WallEnd atFrom = WallEnd::Covered, atTo = WallEnd::Covered;
  std::vector<VesselPinch> pinches;
};

// SurfaceCopy::cut of a vertex of these meshes is a code, which the shader data/shaders/strand.frag
// reads. The code is kLookOfKind times the number of the VesselKind, plus one of these numbers:
// - on the wall's outside 0 to 1: 1 where heat has shrivelled the wall;
// - on the inside 2 (kLookInside) to 3: 2 at the rim of the cut, 3 deep in the lumen.
inline constexpr float kLookOfKind = 4, kLookInside = 2;

// Appends a wall as a closed mesh. The vessel's thickness varies a little along its length, but not
// where the vessel joins others.
void addWall(SurfaceCopy& mesh, const VesselWall& wall);

// Two unit vectors u, v at right angles to the direction `way`, so that u, v, way are right-handed.
// u is as near to `like` as possible.
std::pair<Vec3, Vec3> across(const Vec3& way, const Vec3& like);

// Appends a closed clip that lies across a vessel: a bent bar whose two legs press the vessel flat.
// along: the vessel's direction, unit. u: the legs' direction, unit. outside: outer
// radius of the vessel, m. normals: gets one normal per new point.
void addClip(TriangleMesh& mesh, std::vector<Vec3f>& normals, const Vec3& middle, const Vec3& along,
             const Vec3& u, double outside);

}  // namespace resect

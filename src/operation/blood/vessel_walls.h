// Meshes of bare vessels, for viewers: walls with their ends, and clips.
#pragma once

#include <vector>

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"
#include "surface/surface_update.h"

namespace resect {

// A smooth curve from a to b (cubic Hermite). slopeA, slopeB: derivatives at its ends, m.
struct SmoothWay {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero(), slopeA = Vec3::Zero(), slopeB = Vec3::Zero();

  Vec3 at(double share) const;         // share: 0 to 1
  Vec3 direction(double share) const;  // unit
};

// Where something narrows a vessel: a clip, which presses it flat, or heat, which shrivels it.
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
  double lumen = 0, outside = 0;      // radii of lumen and wall, m
  double outsideA = 0, outsideB = 0;  // radius of the wall where it joins its neighbours, m
  SmoothWay present, rest;            // in the world, and in rest space
  double from = 0, to = 1;            // the wall stands between these fractions
  WallEnd atFrom = WallEnd::Covered, atTo = WallEnd::Covered;
  std::vector<VesselPinch> pinches;
};

// The cut share of a vertex says what it shows, for data/shaders/strand.frag: 4 times the number of
// the kind, plus 0 to 1 for the wall's outside (1 where heat has shrivelled it), or 2 to 3 for the
// inside (from the rim of the cut to the depth of the lumen).
inline constexpr float kLookOfKind = 4, kLookInside = 2;

// Appends a wall as a closed mesh. Its thickness varies a little along the vessel, but not where
// the vessel joins others.
void addWall(SurfaceCopy& mesh, const VesselWall& wall);

// Unit vectors at right angles to a way, right-handed with it; the first one is as near to `like`
// as possible.
std::pair<Vec3, Vec3> across(const Vec3& way, const Vec3& like);

// Appends a closed clip that lies across a vessel: a bent wire of titanium whose two legs press the
// vessel flat. along: the vessel's direction, unit. u: the legs' direction. normals: one per point.
void addClip(TriangleMesh& mesh, std::vector<Vec3f>& normals, const Vec3& middle, const Vec3& along,
             const Vec3& u, double outside);

}  // namespace resect

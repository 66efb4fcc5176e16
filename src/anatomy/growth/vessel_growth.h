// Grows the vessels of a liver into any closed surface.
#pragma once

#include <cstdint>
#include <span>

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"

namespace resect {

inline constexpr int kHepaticTrunks = 3;

struct VesselGrowth {
  // Number of terminals (ends of branches) of the portal vein, 30 to 5000. All hepatic veins
  // together have the same number of terminals.
  int terminals = 1000;
  std::uint64_t seed = 1;
  Vec3 hilum = Vec3::Zero();     // where portal vein, artery and duct enter the organ, m
  Vec3 hilumOut = Vec3::Zero();  // where the portal vein begins, outside the organ, m
  Vec3 cava = Vec3::Zero();      // where the hepatic veins leave the organ, m
  Vec3 cavaOut = Vec3::Zero();   // where the hepatic veins meet, outside the organ, m
  double portalRadius = 0.006;   // radius of the portal vein at the hilum, m
  double trunkRadius = 0.005;    // radius of each of the three hepatic veins, m
  // Radius of the artery, and radius of the bile duct, divided by the radius of the portal vein's
  // branch that they accompany.
  double arteryShare = 0.38, ductShare = 0.33;
  double gap = 0.0004;    // least gap between vessels, m
  double margin = 0.001;  // least depth below the organ's surface, m
  // Outer radius of a portal triad (anatomy/growth/triads.h), divided by the radius of its vein.
  double sheath = 1.95;
};

// The portal vein and the hepatic veins grow at the same time and compete for the space in the
// organ. The artery and the bile duct accompany the portal vein. surface: closed and oriented
// outwards, in m. The same input gives the same bits on every machine. Throws Error if a setting is
// out of range or the organ is too small. Cost: about a second for 1000 terminals. Method:
// docs/methods/vessels.md.
//
// given: vessels that exist already; each segment comes after its parent, as in an Anatomy.
// Existing portal veins and hepatic veins keep their shape, and smaller vessels grow from them. If
// a portal vein exists, `hilum` and `hilumOut` are not used. If hepatic veins exist, `cava` and
// `cavaOut` are not used. An existing artery or bile duct is kept, and no vessels grow from it.
Anatomy growVessels(const TriangleMesh& surface, const VesselGrowth& settings,
                    std::span<const VesselSegment> given = {});

}  // namespace resect

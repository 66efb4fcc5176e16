// Grows the vessels of a liver into any closed surface.
#pragma once

#include <cstdint>
#include <span>

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"

namespace resect {

inline constexpr int kHepaticTrunks = 3;

struct VesselGrowth {
  int terminals = 1000;  // of each kind, 30 to 5000
  std::uint64_t seed = 1;
  Vec3 hilum = Vec3::Zero();     // where portal vein, artery and duct enter the organ, m
  Vec3 hilumOut = Vec3::Zero();  // a point outside, from which the portal vein comes, m
  Vec3 cava = Vec3::Zero();      // where the hepatic veins leave the organ, m
  Vec3 cavaOut = Vec3::Zero();   // a point outside, in the vena cava, m
  double portalRadius = 0.006;   // of the portal vein where it enters, m
  double trunkRadius = 0.005;    // of each of the three hepatic veins, m
  double arteryShare = 0.38, ductShare = 0.33;  // their radii / radius of the portal branch
  double gap = 0.0004;                          // least gap between vessels, m
  double margin = 0.001;                        // least depth below the organ's surface, m
  double sheath = 1.95;                         // radius of a portal triad / radius of its vein
};

// Portal vein and hepatic veins grow in competition for the organ; artery and duct accompany the
// portal vein. surface: closed, oriented outwards, m. The same input gives the same bits on every
// machine. Throws Error if a setting is out of range or the organ is too small. Cost: about a
// second for 1000 terminals. Method: docs/methods/vessels.md.
//
// given: vessels that exist already, with parents as in an Anatomy. Given portal and hepatic veins
// keep their shape, and smaller vessels grow from them. The place of the hilum is not used if a
// portal vein is given, and that of the vena cava is not used if hepatic veins are given. A given
// artery or duct is kept, and no vessels grow from it.
Anatomy growVessels(const TriangleMesh& surface, const VesselGrowth& settings,
                    std::span<const VesselSegment> given = {});

}  // namespace resect

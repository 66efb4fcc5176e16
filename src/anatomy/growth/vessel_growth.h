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
  Vec3 hilumOut = Vec3::Zero();  // a place outside, from which the portal vein comes, m
  Vec3 cava = Vec3::Zero();      // where the hepatic veins leave, m
  Vec3 cavaOut = Vec3::Zero();   // a place outside, in the vena cava, m
  double portalRadius = 0.006;   // of the portal vein where it enters, m
  double trunkRadius = 0.005;    // of each of three hepatic veins, m
  double arteryShare = 0.38, ductShare = 0.33;  // radii over that of the portal branch beside
  double gap = 0.0004;                          // between vessels, m
  double margin = 0.001;                        // below the organ's surface, m
  double sheath = 1.95;                         // radius of a portal triad over that of its vein
};

// Portal vein and hepatic veins compete for the organ; artery and duct accompany the portal vein.
// `surface`: closed, oriented outwards, m. The same input gives the same bits on every machine.
// Throws Error if a setting is out of range or the organ is too small. Cost: about a second
// for 1000 terminals. Method: docs/methods/vessels.md.
//
// given: vessels that are there already, with parents as in an Anatomy. Those of the portal vein
// and the hepatic veins stay as they are, and smaller ones grow from them; hilum or vena cava are
// then not used. A given artery or duct stays as it is, and nothing grows from it.
Anatomy growVessels(const TriangleMesh& surface, const VesselGrowth& settings,
                    std::span<const VesselSegment> given = {});

}  // namespace resect

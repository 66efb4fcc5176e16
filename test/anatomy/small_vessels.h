// Small anatomies for tests: a straight vessel, and a tree with two branches.
#pragma once

#include "anatomy/vessel_map.h"
#include "collision/swept_blade.h"

namespace resect::test {

// One vessel of a kind from `start` to `end`; its end is a leaf.
inline Anatomy straightVessel(VesselKind kind, const Vec3& start, const Vec3& end, double radius) {
  return makeAnatomy({{kind, -1, start, end, radius, true}});
}

// A stem along x that parts into two branches, of each of the three kinds that carry blood, side by
// side along z from the origin.
inline Anatomy threeForks() {
  std::vector<VesselSegment> all;
  int row = 0;
  for (const VesselKind kind :
       {VesselKind::PortalVein, VesselKind::HepaticVein, VesselKind::HepaticArtery}) {
    const Vec3 at(0, 0, 0.02 * row++);
    const std::int32_t stem = std::int32_t(all.size());
    all.push_back({kind, -1, at, at + Vec3(0.03, 0, 0), 0.006, false});
    for (const double side : {-1.0, 1.0})
      all.push_back(
          {kind, stem, at + Vec3(0.03, 0, 0), at + Vec3(0.05, 0.02 * side, 0), 0.0045, true});
  }
  return makeAnatomy(std::move(all));
}

// A blade that cuts across x, from the middle of the vessel outwards and beyond.
inline SweptBlade acrossX(double x, double low, double high) {
  const Vec3 before[] = {{x, low, -1}, {x, high, -1}}, after[] = {{x, low, 1}, {x, high, 1}};
  return ruledBlade(before, after);
}

}  // namespace resect::test

// How vessels grow in a ball of 6 cm radius round the origin, with the hilum below and the cava
// above.
#pragma once

#include "anatomy/growth/vessel_growth.h"

namespace resect::test {

inline VesselGrowth ballGrowth(std::uint64_t seed) {
  VesselGrowth g;
  g.terminals = 200;
  g.seed = seed;
  g.hilum = Vec3(0.01, -0.045, 0);
  g.hilumOut = Vec3(0.01, -0.09, 0);
  g.cava = Vec3(-0.01, 0.045, -0.01);
  g.cavaOut = Vec3(-0.01, 0.08, -0.01);
  return g;
}

}  // namespace resect::test

// The Visible Human's liver, if present, and where its vessels grow from.
#pragma once

#include "anatomy/growth/vessel_growth.h"
#include "support/references/mesh_reference.h"
#include "support/shared_data.h"

namespace resect::test {

// 16 898 triangles, closed. Nothing, and a line "skipped", without the optional data.
inline std::optional<TriangleMesh> visibleHumanLiver() {
  const auto path = sharedData("visible-human-male/VH_M_liver_closed.obj");
  if (!path) return std::nullopt;
  return readPlainObj(path->string());
}

// Where its portal vein enters, and its hepatic veins meet.
inline VesselGrowth visibleHumanVessels() {
  VesselGrowth growth;
  growth.hilum = Vec3(0.000, 0.333, 0.028);
  growth.hilumOut = Vec3(0.010, 0.290, 0.020);
  growth.cava = Vec3(-0.029, 0.423, -0.007);
  growth.cavaOut = Vec3(-0.029, 0.450, -0.040);
  return growth;
}

}  // namespace resect::test

// Twelve organs as people bring them: closed meshes of about the size and shape of a human's, made
// of ellipsoids and tubes that blend into each other. Hollow organs have walls.
#pragma once

#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect::test {

struct BroughtOrgan {
  std::string name;
  bool hollow = false;
  double least = 0, most = 0;  // volume of the tissue, ml
  TriangleMesh mesh;           // m
};

inline constexpr const char* kTwelveOrgans[] = {"liver",       "spleen",  "kidney",  "pancreas",
                                                "gallbladder", "stomach", "lung",    "heart",
                                                "aorta",       "uterus",  "bladder", "brain"};

// One of kTwelveOrgans.
BroughtOrgan broughtOrgan(const std::string& name);

}  // namespace resect::test

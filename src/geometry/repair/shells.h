// The closed shells of a surface, and whether each bounds tissue, a cavity or neither.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

enum class ShellKind : std::uint8_t {
  Body,    // tissue lies inside it and none outside
  Cavity,  // tissue lies outside it and none inside
  Within   // tissue on both sides or on neither, such as an outward shell inside a body
};

struct Shell {
  ShellKind kind = ShellKind::Body;
  double volume = 0;  // enclosed, m^3, >= 0
  Aabb box;           // m
};

// One shell for each component, in the order of splitComponents() (geometry/topology.h). Tissue is
// where the winding number is above zero (crossings.h). The mesh must be closed and oriented. Its
// components must be disjoint or nested, and none may be a speck. Cost: O(n log n) for n triangles,
// and O(components^2) tests of boxes.
std::vector<Shell> shellsOf(const TriangleMesh& mesh);

// The volume of tissue that the shells bound, m^3. It can be less than the volume of the mesh
// (geometry/measures.h), which counts the inside of an outward shell inside a body twice.
double tissueVolume(const std::vector<Shell>& shells);

}  // namespace resect

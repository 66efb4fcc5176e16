// Finds the closed shells of a surface, and whether each shell bounds tissue, a cavity, or neither
// of them.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

enum class ShellKind : std::uint8_t {
  Body,    // there is tissue at the shell's inner side and no tissue at its outer side
  Cavity,  // there is tissue at the shell's outer side and no tissue at its inner side
  // There is tissue at both sides or at neither side. An example is a shell that faces outwards
  // and lies inside a body.
  Within
};

struct Shell {
  ShellKind kind = ShellKind::Body;
  double volume = 0;  // volume that the shell encloses, m^3, >= 0
  Aabb box;           // bounds of the shell, m
};

// Each component of the mesh is a shell. The shells have the order of splitComponents()
// (geometry/topology.h). Tissue is where the winding number is above zero
// (geometry/repair/crossings.h). The mesh must be closed and oriented. Its components must be
// disjoint or nested, and none of them may be a speck (isSpeck() in geometry/repair/mesh_health.h).
// Cost for n triangles and c components: O(n log n), and O(c^2) tests of bounding boxes.
std::vector<Shell> shellsOf(const TriangleMesh& mesh);

// The volume of the tissue that the shells bound, m^3. It can be less than volume() of the mesh
// (geometry/measures.h). If a shell inside a body faces outwards, volume() counts the inside of
// this shell twice, and tissueVolume() counts it once.
double tissueVolume(const std::vector<Shell>& shells);

}  // namespace resect

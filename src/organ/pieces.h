// Into how many bodies has an organ come apart?
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// The separate solid bodies that a closed surface bounds, the largest first: a component of
// positive volume is a body's skin; one of negative volume a cavity and stays with the smallest
// body round it. Each body is a closed mesh.
std::vector<TriangleMesh> bodies(const TriangleMesh& surface);

}  // namespace resect

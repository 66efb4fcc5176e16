// Cords: springs between cells that stand for the walls of vessels in the tissue.
//
// A cord that is longer than at rest pulls its two cells together along the line between them. A
// cord that is shorter than at rest exerts no force. Cords do not resist bending.
#pragma once

#include <cstdint>

namespace resect {

struct TissueCord {
  std::int64_t a = -1, b = -1;  // indices of its two cells in the lattice, a != b
  double stiffness = 0;         // N/m
};

}  // namespace resect

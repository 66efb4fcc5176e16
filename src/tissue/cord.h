// Cords: springs that stand for the walls of vessels in the tissue. Each cord connects two cells of
// the organ's lattice.
//
// A cord that is longer than at rest pulls its two cells together along the line between them. A
// cord that is shorter than at rest exerts no force. Cords do not resist bending.
#pragma once

#include <cstdint>

namespace resect {

struct TissueCord {
  std::int64_t a = -1, b = -1;  // lattice indices of its two cells, a != b
  double stiffness = 0;         // N/m
};

}  // namespace resect

// Cords: vessels as the tissue feels them.
//
// A cord pulls two cells together along the line between them when it is longer than at rest; when
// it is shorter it hangs slack. It does not resist bending.
#pragma once

#include <cstdint>

namespace resect {

struct TissueCord {
  std::int64_t a = -1, b = -1;  // its two cells, different: indices in the lattice
  double stiffness = 0;         // N/m
};

}  // namespace resect

// Vector operations on four vertices at a time, for the loops over a brick's vertices.
//
// The functions are inlined, so that they are compiled for the instruction set of their caller.
#pragma once

#include <cstdint>
#include <cstring>

#include "base/vec.h"

namespace resect {

typedef float FourFloats __attribute__((vector_size(16)));

// Writes four points to `out`. x, y, z: the coordinates of the four points.
[[gnu::always_inline]] inline void storePoints(const FourFloats& x, const FourFloats& y,
                                               const FourFloats& z, Vec3f* out) {
  const FourFloats zx = __builtin_shufflevector(z, x, 0, 0, 5, 5),
                   yz = __builtin_shufflevector(y, z, 1, 1, 5, 5),
                   zx3 = __builtin_shufflevector(z, x, 2, 2, 7, 7),
                   yz3 = __builtin_shufflevector(y, z, 3, 3, 7, 7),
                   low = __builtin_shufflevector(x, y, 0, 4, 1, 5),
                   high = __builtin_shufflevector(x, y, 2, 6, 3, 7);
  const FourFloats first = __builtin_shufflevector(low, zx, 0, 1, 4, 6),
                   second = __builtin_shufflevector(yz, high, 0, 2, 4, 5),
                   third = __builtin_shufflevector(zx3, yz3, 0, 2, 4, 6);
  float* to = out->data();
  std::memcpy(to, &first, sizeof first);
  std::memcpy(to + 4, &second, sizeof second);
  std::memcpy(to + 8, &third, sizeof third);
}

// Position of each of four vertices along its grid edge: from 0 at the lower node to 1 at the upper
// node. lower, upper: the values of the field at these nodes. The field has the value `iso` at the
// vertex. The position is found by linear interpolation and then limited to [margin, 1 - margin].
[[gnu::always_inline]] inline FourFloats wayAlong(const FourFloats& lower, const FourFloats& upper,
                                                  float iso, float margin) {
  const FourFloats crossing = (iso - lower) / (upper - lower);
  const FourFloats least = FourFloats{} + margin, most = 1 - least;
  const FourFloats way = crossing > least ? crossing : least;
  return way < most ? way : most;
}

}  // namespace resect

// What is an organ before it comes to life? Colour values on a lattice: how much of each cell is
// tissue.
#pragma once

#include <cstdint>
#include <vector>

#include "sph/lattice.h"

namespace resect {

// Arrays have one entry per lattice cell, x fastest.
struct Discretization {
  Lattice lattice;
  // Colour value in [0, 100]: per cent of the cell inside the organ (0 or 100 in the thesis's
  // files).
  std::vector<float> value;
  // 1 where the cell's centre is inside: these cells are the particles. Cells with value > 0 that
  // are no particle are the skin's share outside; each belongs to a particle beside it.
  std::vector<std::uint8_t> inside;

  std::int64_t particleCount() const {
    std::int64_t count = 0;
    for (std::uint8_t flag : inside) count += flag;
    return count;
  }
  double volume() const {  // m^3
    double sum = 0;
    for (float v : value) sum += v;
    return sum / 100 * lattice.cellVolume();
  }
};

}  // namespace resect

// What is an organ before it comes to life? Colour values on a lattice: how much of each cell is
// tissue.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sph/colour_values.h"
#include "sph/lattice.h"
#include "sph/region.h"

namespace resect {

// Arrays have one entry per lattice cell, x fastest.
struct Discretization {
  Lattice lattice;
  // Per cent of the cell inside the organ (0 or 100 in the thesis's files).
  ColourValues value;
  // 1 where the cell's centre is inside: these cells are the particles. Cells with value > 0 that
  // are no particle are the skin's share outside; each belongs to a particle beside it.
  std::vector<std::uint8_t> inside;
  // Fitted values (organ/fit_surface.h) draw the body's surface rather than fill its cells; those
  // between 0 and 100 times this add up to its volume.
  double skinScale = 1;
  // Which structure each cell belongs to; 0 is the organ's own parenchyma. Empty: all 0.
  std::vector<std::uint8_t> label;
  std::vector<std::string> labelNames;  // by label; what has none is empty or beyond the end
  std::vector<Landmark> landmarks;

  std::uint8_t labelOf(std::int64_t cell) const {
    return label.empty() ? std::uint8_t(0) : label[std::size_t(cell)];
  }
  // For people: "tumour", or "label 3" for one that was given no name.
  std::string labelName(int number) const {
    if (std::size_t(number) < labelNames.size() && !labelNames[std::size_t(number)].empty())
      return labelNames[std::size_t(number)];
    return number == 0 ? "parenchyma" : "label " + std::to_string(number);
  }
  void nameLabel(int number, const std::string& name) {
    if (labelNames.size() <= std::size_t(number)) labelNames.resize(std::size_t(number) + 1);
    labelNames[std::size_t(number)] = name;
  }
  std::int64_t particleCount() const {
    std::int64_t count = 0;
    for (std::uint8_t flag : inside) count += flag;
    return count;
  }
  double cellVolume(std::int64_t cell) const {  // of the tissue in a cell, m^3
    const float v = value[cell];
    return (v < 100 ? skinScale * v : v) / 100 * lattice.cellVolume();
  }
  std::size_t bytes() const {
    return value.bytes() + inside.capacity() + label.capacity();
  }                        // memory held
  double volume() const {  // m^3
    double sum = 0;
    for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell) sum += cellVolume(cell);
    return sum;
  }
};

}  // namespace resect

// An organ before the operation: colour values on a lattice, with particles, labels and landmarks.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "sph/colour_values.h"
#include "sph/lattice.h"
#include "sph/region.h"

namespace resect {

// Arrays have one entry per lattice cell, x fastest.
struct Discretization {
  Lattice lattice;
  // How much of each cell is inside the organ, per cent. In .dis files, the format of the diploma
  // thesis that Resect continues, there are only 0 and 100.
  ColourValues value;
  // 1 where the cell's centre is inside the organ, else 0. The cells with 1 are the particles. Any
  // other cell with a value above 0 is a skin cell: some of it is filled, but its centre is
  // outside. Each skin cell belongs to a particle beside it.
  std::vector<std::uint8_t> inside;
  // Fitted colour values (organ/fit_surface.h) reproduce the organ's surface, but not its volume.
  // To correct the volume, cellVolume() multiplies values below 100 by this factor.
  double skinScale = 1;
  // Label of each cell: the structure that it belongs to; 0 is the parenchyma, the organ's own
  // tissue. If the array is empty, all cells have label 0.
  std::vector<std::uint8_t> label;
  // Names, indexed by label; empty for a label without a name. Labels beyond the end of the vector
  // have no name either.
  std::vector<std::string> labelNames;
  std::vector<Landmark> landmarks;

  std::uint8_t labelOf(std::int64_t cell) const {
    return label.empty() ? std::uint8_t(0) : label[std::size_t(cell)];
  }
  // Name of a label for people, such as "tumour". If a label has no name, the result is
  // "parenchyma" for label 0 and, for example, "label 3" for label 3.
  std::string labelName(int number) const {
    if (std::size_t(number) < labelNames.size() && !labelNames[std::size_t(number)].empty())
      return labelNames[std::size_t(number)];
    return number == 0 ? "parenchyma" : "label " + std::to_string(number);
  }
  void nameLabel(int number, const std::string& name) {  // number: 0 to 255
    require(number >= 0 && number <= 255, "label {} was named; give 0 to 255", number);
    if (labelNames.size() <= std::size_t(number)) labelNames.resize(std::size_t(number) + 1);
    labelNames[std::size_t(number)] = name;
  }
  std::int64_t particleCount() const {
    std::int64_t count = 0;
    for (std::uint8_t flag : inside) count += flag;
    return count;
  }
  double cellVolume(std::int64_t cell) const {  // volume of the tissue in a cell, m^3
    const float v = value[cell];
    return (v < 100 ? skinScale * v : v) / 100 * lattice.cellVolume();
  }
  std::size_t bytes() const {  // memory held
    return value.bytes() + inside.capacity() + label.capacity();
  }
  double volume() const {  // of all tissue, m^3
    double sum = 0;
    for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell) sum += cellVolume(cell);
    return sum;
  }
};

// Throws Error if Lattice::sound() is false, or if an array does not have one entry per cell.
// `label` may be empty.
void requireSound(const Discretization& cells);

}  // namespace resect

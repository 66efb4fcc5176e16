// The parts of an organ's tissue: sets of particles that bonds connect.
//
// Two particles that are neighbours in the lattice (26 neighbours per cell) are connected unless
// the bond between them was severed by a blade, by jaws or by a tear. So even a slit that is
// thinner than a cell separates parts. Parts are found from the present state alone, anew at each
// call.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "organ/operated_organ.h"

namespace resect {

// Consecutive cells along x that belong to one part.
struct CellRun {
  std::int64_t first = 0;  // index in the lattice
  std::int32_t length = 0;
  std::int32_t part = 0;
};

struct TissueParts {
  std::vector<CellRun> runs;  // of all cells with tissue, ascending
  std::int32_t count = 0;     // number of parts; their numbers ascend with their first cells
};

// The largest part of an organ is its body. All other parts are pieces or debris. A part is a piece
// if its volume is at least kPieceVolume, m^3, and also at least the volume of kPieceCells cells.
// (Without the second condition, one large cell could be a piece.) A part is a piece, too, if its
// volume is at least the share kPieceShare of the organ's volume.
inline constexpr double kPieceVolume = 0.5e-6, kPieceShare = 0.01;
inline constexpr int kPieceCells = 4;
// The least volume of a piece, m^3. organ, cell: volume of the organ and of a cell, m^3.
inline double leastPiece(double organ, double cell) {
  return std::min(std::max(kPieceVolume, kPieceCells * cell), kPieceShare * organ);
}

// Cost for still tissue: a pass over one byte per cell of the lattice, and 0.1 us per cell beside a
// cut. Cost for moving tissue: 0.1 us per particle.
TissueParts tissueParts(const OperatedOrgan& organ);

}  // namespace resect

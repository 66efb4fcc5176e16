#include "operation/ledger/segment_amounts.h"

#include <algorithm>

#include "organ/parts/tissue_parts.h"

namespace resect {

std::vector<SegmentAmount> segmentAmounts(const OperatedOrgan& operated) {
  const Organ& organ = operated.organ;
  if (!organ.map || !organ.map->segments) return {};
  const Lattice& lattice = organ.rest.lattice;
  const auto segmentOf = [&](std::int64_t cell) {
    return std::size_t(organ.map->segments->at(lattice.centre(lattice.cell(cell))) - 1);
  };
  std::vector<SegmentAmount> all(kLiverSegments);
  for (int k = 0; k < kLiverSegments; ++k) all[std::size_t(k)].segment = k + 1;
  const double volume = lattice.cellVolume();
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell)
    if (organ.rest.inside[std::size_t(cell)]) all[segmentOf(cell)].before += volume;

  const TissueParts parts = tissueParts(operated);
  std::vector<std::int64_t> cells(std::size_t(parts.count), 0);
  for (const CellRun& run : parts.runs) cells[std::size_t(run.part)] += run.length;
  if (cells.empty()) return all;
  const auto body = std::int32_t(std::ranges::max_element(cells) - cells.begin());
  for (const CellRun& run : parts.runs)
    for (std::int64_t cell = run.first; run.part == body && cell < run.first + run.length; ++cell)
      if (organ.rest.inside[std::size_t(cell)]) all[segmentOf(cell)].body += volume;
  return all;
}

}  // namespace resect

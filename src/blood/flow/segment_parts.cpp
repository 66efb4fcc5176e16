#include "blood/flow/segment_parts.h"

#include <algorithm>

#include "organ/parts/tissue_parts.h"

namespace resect {

std::vector<std::int32_t> partOfCells(const OperatedOrgan& organ) {
  const Lattice& lattice = organ.organ.rest.lattice;
  const TissueParts parts = tissueParts(organ);
  std::vector<std::int64_t> cells(std::size_t(parts.count), 0);  // by part
  std::int64_t all = 0;
  for (const CellRun& run : parts.runs) cells[std::size_t(run.part)] += run.length;
  for (const std::int64_t count : cells) all += count;
  const double cell = lattice.cellVolume();
  const double least = leastPiece(double(all) * cell, cell);
  std::vector<std::int32_t> number(cells.size(), SegmentPart::kCrumb);
  if (cells.empty())
    return std::vector<std::int32_t>(std::size_t(lattice.cellCount()), SegmentPart::kCrumb);
  const std::size_t body = std::size_t(std::ranges::max_element(cells) - cells.begin());
  std::int32_t pieces = 0;
  for (std::size_t p = 0; p < cells.size(); ++p)
    if (p == body)
      number[p] = 0;
    else if (double(cells[p]) * cell >= least)
      number[p] = ++pieces;
  std::vector<std::int32_t> of(std::size_t(lattice.cellCount()), SegmentPart::kCrumb);
  for (const CellRun& run : parts.runs)
    std::fill_n(of.begin() + run.first, run.length, number[std::size_t(run.part)]);
  return of;
}

std::vector<SegmentPart> segmentsApart(const Organ& organ, std::span<const std::int32_t> part) {
  const std::vector<VesselSegment>& segments = organ.map->anatomy.segments;
  const Lattice& lattice = organ.rest.lattice;
  std::vector<std::int32_t> place(segments.size(), SegmentPart::kCrumb);
  std::vector<SegmentPart> apart;
  // Parents stand before their children, which have told them their part.
  for (std::size_t i = segments.size(); i-- > 0;) {
    const VesselSegment& s = segments[i];
    for (const double share : {1.0, 0.5, 0.0}) {  // a leaf may end just outside the cells
      if (place[i] != SegmentPart::kCrumb) break;
      if (const auto cell = lattice.cellAt(s.at(share)))
        place[i] = part[std::size_t(lattice.index(*cell))];
    }
    if (s.parent >= 0 && place[std::size_t(s.parent)] == SegmentPart::kCrumb)
      place[std::size_t(s.parent)] = place[i];
    if (place[i] != 0) apart.push_back({std::int32_t(i), place[i]});
  }
  std::ranges::reverse(apart);
  return apart;
}

}  // namespace resect

#include "organ/vessel_cords.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "organ/picture/picture_vessels.h"

namespace resect {
namespace {

constexpr double kStep = 0.5;  // spacings between places along a vessel

double stiffnessOf(const VesselSegment& s, double length) {
  const double wall = wallOf(s.kind, s.radius);
  const double area = std::numbers::pi * wall * (2 * s.radius + wall);
  return kWallModulus * area / length;
}

// Which segments are cords: the wide ones, those that run bare, and the neighbours of these, in
// which they go on into the tissue.
std::vector<char> corded(const Organ& organ) {
  const std::vector<VesselSegment>& segments = organ.map->anatomy.segments;
  const std::vector<std::int32_t>& bared = organ.vessels.bared;
  std::vector<char> is(segments.size(), 0);
  const auto isBared = [&](std::int32_t i) { return std::ranges::binary_search(bared, i); };
  for (std::size_t i = 0; i < segments.size(); ++i) is[i] = segments[i].radius >= kWideVessel;
  if (bared.empty()) return is;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::int32_t parent = segments[i].parent;
    const bool own = isBared(std::int32_t(i));
    is[i] |= own || (parent >= 0 && isBared(parent));
    if (own && parent >= 0) is[std::size_t(parent)] = 1;
  }
  return is;
}

}  // namespace

std::vector<VesselCord> vesselCords(const Organ& organ, const TissueModel& tissue) {
  std::vector<VesselCord> cords;
  if (!organ.map || !tissue.moves()) return cords;
  const Lattice& lattice = organ.rest.lattice;
  const std::vector<VesselSegment>& segments = organ.map->anatomy.segments;
  const std::vector<char> is = corded(organ);
  std::vector<std::int64_t> last(segments.size(), -1);  // cell of tissue at the segment's end
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const VesselSegment& s = segments[i];
    if (!is[i]) continue;
    std::int64_t before = s.parent >= 0 ? last[std::size_t(s.parent)] : -1;
    const VesselInjury* injury = organ.vessels.injury(std::int32_t(i));
    bool whole = !injury || !injury->severed();
    std::int64_t cut = -1;  // the cell of the cut is held from the root's side only
    const int steps = 1 + int(s.length() / (kStep * lattice.spacing.x()));
    for (int k = 0; k <= steps; ++k) {
      const double share = double(k) / steps;
      const auto at = lattice.cellAt(s.at(share));
      const std::int64_t cell = at ? lattice.index(*at) : -1;
      if (!whole && share >= injury->from) cut = before, before = -1, whole = true;
      if (cell < 0 || cell == before || cell == cut || !tissue.solid(cell)) continue;
      if (before >= 0) {
        const double length = (lattice.centre(*at) - lattice.centre(lattice.cell(before))).norm();
        cords.push_back({{before, cell, stiffnessOf(s, length)}, std::int32_t(i), share});
      }
      before = cell;
    }
    last[i] = before;
  }
  return cords;
}

void renewCords(OperatedOrgan& organ) {
  organ.cords = vesselCords(organ.organ, *organ.tissue);
  std::vector<TissueCord> cords;
  for (const VesselCord& one : organ.cords) cords.push_back(one.cord);
  organ.tissue->setCords(cords);
}

std::vector<DivideVessel> brokenVessels(const OperatedOrgan& organ) {
  const Lattice& lattice = organ.organ.rest.lattice;
  std::vector<DivideVessel> broken;
  for (const VesselCord& one : organ.cords) {
    const auto [a, b, stiffness] = one.cord;
    const Vec3 rest = lattice.centre(lattice.cell(b)) - lattice.centre(lattice.cell(a));
    const Vec3 now = rest + organ.tissue->displacement(b) - organ.tissue->displacement(a);
    if (now.norm() > kBreakStretch * rest.norm()) broken.push_back({one.segment, one.share});
  }
  return broken;
}

}  // namespace resect

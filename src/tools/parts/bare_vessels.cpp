#include "tools/parts/bare_vessels.h"

#include "tools/rest_place.h"

namespace resect {

void divideBareVessels(const Touch& touch, const SweptBlade& sweep,
                       std::vector<TissueEdit>& edits) {
  if (sweep.empty()) return;
  const Organ& organ = touch.organ;
  const Lattice& lattice = organ.rest.lattice;
  for (const std::int32_t i : organ.vessels.bared) {
    const VesselSegment& s = organ.map->anatomy.segments[std::size_t(i)];
    const auto at = crossing(sweep, presentPlace(organ, touch.tissue, s.start),
                             presentPlace(organ, touch.tissue, s.end));
    if (!at) continue;
    const auto cell = lattice.cellAt(s.at(at->share));
    const bool inTissue = cell && organ.alive[std::size_t(lattice.index(*cell))] != 0;
    if (!inTissue) edits.push_back(touch.edit(DivideVessel{i, at->share}));
  }
}

}  // namespace resect

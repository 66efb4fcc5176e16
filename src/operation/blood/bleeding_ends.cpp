#include "operation/blood/bleeding_ends.h"

#include "tools/rest_place.h"

namespace resect {

std::vector<BleedingEnd> bleedingEnds(const Simulation& simulation) {
  std::vector<BleedingEnd> ends;
  for (std::size_t o = 0; o < simulation.organs().size(); ++o) {
    const OperatedOrgan& operated = simulation.organs()[o];
    const Organ& organ = operated.organ;
    for (const VesselInjury& injury : organ.vessels.injuries)
      for (const VesselEnd end : {VesselEnd::Root, VesselEnd::Far}) {
        const double flow = injury.flow[int(end)];
        if (flow == 0) continue;
        const VesselSegment& s = organ.map->anatomy.segments[std::size_t(injury.segment)];
        const Vec3 place = s.at(end == VesselEnd::Root ? injury.from : injury.to);
        ends.push_back({std::int32_t(o), injury.segment, end,
                        presentPlace(organ, *operated.tissue, place), flow, s.radius});
      }
  }
  return ends;
}

}  // namespace resect

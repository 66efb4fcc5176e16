#include "operation/blood/blood_summary.h"

#include <algorithm>
#include <set>

#include "anatomy/vessel_closure.h"
#include "base/elementary.h"
#include "tools/rest_place.h"

namespace resect {
namespace {

constexpr double kMeanTime = 1;  // s: rates are means over about this time

}  // namespace

void BloodBooks::add(const StepReport& report, double duration) {
  const double share = 1 - math::exp(-duration / kMeanTime);
  rate_ += share * (report.blood.rate - rate_);
  highest_ = std::max(highest_, rate_);
}

std::vector<CutVesselSummary> cutVessels(const OperatedOrgan& operated) {
  const Organ& organ = operated.organ;
  std::vector<CutVesselSummary> all;
  for (const VesselInjury& injury : organ.vessels.injuries) {
    const VesselSegment& s = organ.map->anatomy.segments[std::size_t(injury.segment)];
    all.push_back({s.kind, organ.map->nameOf(injury.segment), 2 * s.radius, injury.severed(),
                   isClosed(organ.map->anatomy, organ.vessels, injury), injury.bled,
                   std::max(0.0, injury.flow[0]) + std::max(0.0, injury.flow[1]),
                   presentPlace(organ, *operated.tissue, s.at(injury.from))});
  }
  std::ranges::stable_sort(all, std::greater<>(), &CutVesselSummary::diameter);
  return all;
}

std::vector<BareVesselSummary> bareVesselsOf(const OperatedOrgan& operated) {
  constexpr int kPlaces = 64;  // along a segment
  const Organ& organ = operated.organ;
  const Lattice& lattice = organ.rest.lattice;
  std::vector<BareVesselSummary> all;
  for (const std::int32_t i : organ.vessels.bared) {
    const VesselSegment& s = organ.map->anatomy.segments[std::size_t(i)];
    int first = -1, last = -1;
    for (int k = 0; k < kPlaces; ++k) {
      const auto cell = lattice.cellAt(s.at((k + 0.5) / kPlaces));
      if (cell && organ.alive[std::size_t(lattice.index(*cell))]) continue;
      if (first < 0) first = k;
      last = k;
    }
    if (first < 0) continue;
    const auto placed = [&](double share) {
      return presentPlace(organ, *operated.tissue, s.at(share));
    };
    const Vec3 from = placed(double(first) / kPlaces), to = placed((last + 1.0) / kPlaces);
    BareVesselSummary bare{s.kind,
                           organ.map->nameOf(i),
                           2 * s.radius,
                           0.5 * (from + to),
                           (to - from).normalized(),
                           (to - from).norm()};
    bare.divided = organ.vessels.injury(i) != nullptr;
    bare.closures = int(std::ranges::count(organ.vessels.clips, i, &VesselClip::segment));
    all.push_back(bare);
  }
  std::ranges::stable_sort(all, std::greater<>(), &BareVesselSummary::diameter);
  return all;
}

std::optional<BloodSummary> BloodBooks::summaryOf(const Simulation& simulation) const {
  if (!simulation.blood().any()) return {};
  BloodSummary summary;
  summary.ledger = simulation.blood().ledger();
  summary.rate = rate_, summary.highest = highest_;
  summary.air = simulation.blood().air();
  for (const OperatedOrgan& o : simulation.organs()) {
    if (!o.organ.map) continue;
    const std::vector<CutVesselSummary> cut = cutVessels(o);
    summary.vessels.insert(summary.vessels.end(), cut.begin(), cut.end());
    const std::vector<BareVesselSummary> bare = bareVesselsOf(o);
    summary.bare.insert(summary.bare.end(), bare.begin(), bare.end());
    std::set<std::int32_t> sealed;
    for (const VesselClip& clip : o.organ.vessels.clips)
      if (clip.byHeat)
        sealed.insert(clip.segment);
      else
        ++summary.clips;
    summary.sealed += int(sealed.size());
    summary.inflowClamped = std::max(summary.inflowClamped, o.organ.vessels.clampedTime);
  }
  return summary;
}

}  // namespace resect

#include "operation/blood_summary.h"

#include <algorithm>

#include "base/elementary.h"

namespace resect {
namespace {

constexpr double kMeanTime = 1;  // s: rates are means over about this time

}  // namespace

void BloodBooks::add(const StepReport& report, double duration) {
  const double share = 1 - math::exp(-duration / kMeanTime);
  rate_ += share * (report.blood.rate - rate_);
  highest_ = std::max(highest_, rate_);
  air_ += report.blood.airRate * duration;
}

std::vector<CutVesselSummary> cutVessels(const Organ& organ) {
  std::vector<CutVesselSummary> all;
  for (const VesselInjury& injury : organ.vessels.injuries) {
    const VesselSegment& s = organ.map->anatomy.segments[std::size_t(injury.segment)];
    const auto closed = [&](VesselEnd end) {
      return injury.isSealed(end) || organ.vessels.clipped(injury, end);
    };
    all.push_back({s.kind, 2 * s.radius, injury.severed(),
                   closed(VesselEnd::Root) && (!injury.severed() || closed(VesselEnd::Far)),
                   injury.bled});
  }
  std::ranges::stable_sort(all, std::greater<>(), &CutVesselSummary::diameter);
  return all;
}

std::optional<BloodSummary> BloodBooks::summaryOf(const Simulation& simulation) const {
  if (!simulation.blood().any()) return {};
  BloodSummary summary{simulation.blood().ledger(), rate_, highest_, air_, {}};
  for (const OperatedOrgan& o : simulation.organs()) {
    if (!o.organ.map) continue;
    const std::vector<CutVesselSummary> cut = cutVessels(o.organ);
    summary.vessels.insert(summary.vessels.end(), cut.begin(), cut.end());
  }
  return summary;
}

}  // namespace resect

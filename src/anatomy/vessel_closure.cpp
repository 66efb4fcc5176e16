#include "anatomy/vessel_closure.h"

#include <algorithm>

namespace resect {

std::optional<double> wayToClip(const Anatomy& anatomy, const VesselInjury& injury, VesselEnd end,
                                const VesselClip& clip, double reach) {
  const auto lengthOf = [&](std::int32_t i) { return anatomy.segments[std::size_t(i)].length(); };
  // Of the two segments, `upper` feeds `lower`. A segment comes after those that feed it.
  const bool root = end == VesselEnd::Root;
  const std::int32_t upper = root ? clip.segment : injury.segment,
                     lower = root ? injury.segment : clip.segment;
  const double upperShare = root ? clip.share : injury.to,
               lowerShare = root ? injury.from : clip.share;
  double way = lowerShare * lengthOf(lower);
  std::int32_t at = lower;
  while (at > upper && way <= reach) {
    at = anatomy.segments[std::size_t(at)].parent;
    if (at >= 0) way += lengthOf(at);
  }
  if (at != upper) return {};
  way -= upperShare * lengthOf(upper);
  if (way < 0 || way > reach) return {};
  return way;
}

bool isClosed(const Anatomy& anatomy, const VesselState& state, const VesselInjury& injury,
              VesselEnd end, double reach) {
  constexpr double kTrickle = 1e-8;  // m^3/s: more shows that branches lead round a distant clip
  if (injury.isSealed(end) || state.clipped(injury, end)) return true;
  if (injury.flow[int(end)] > kTrickle) return false;
  return std::ranges::any_of(state.clips, [&](const VesselClip& clip) {
    return wayToClip(anatomy, injury, end, clip, reach).has_value();
  });
}

bool isClosed(const Anatomy& anatomy, const VesselState& state, const VesselInjury& injury) {
  return isClosed(anatomy, state, injury, VesselEnd::Root) &&
         (!injury.severed() || isClosed(anatomy, state, injury, VesselEnd::Far));
}

std::vector<VesselClip> slipClips(const Anatomy& anatomy, const std::vector<std::int32_t>& cut,
                                  VesselState& state) {
  std::vector<VesselClip> slipped;
  if (state.clips.empty()) return slipped;
  for (const std::int32_t segment : cut) {
    const VesselInjury* injury = state.injury(segment);
    if (!injury || !injury->severed()) continue;
    std::erase_if(state.clips, [&](const VesselClip& clip) {
      if (clip.byHeat) return false;
      const bool inGap =
          clip.segment == segment && clip.share > injury->from && clip.share < injury->to;
      const auto close = [&](VesselEnd end) {
        return wayToClip(anatomy, *injury, end, clip, kLeastStump).has_value();
      };
      if (!inGap && !close(VesselEnd::Root) && !close(VesselEnd::Far)) return false;
      slipped.push_back(clip);
      return true;
    });
  }
  return slipped;
}

}  // namespace resect

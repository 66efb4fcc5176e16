#include "skills/attempt/attempt.h"

#include <algorithm>
#include <cmath>

namespace resect {

std::vector<Track> tracksOf(const Attempt& attempt, const InstrumentRecord& instrument) {
  std::vector<Track> tracks;
  bool before = false;
  for (const ToolMoment& now : instrument.moments) {
    if (now.taken && !before) tracks.push_back({attempt.interval, {}, {}, instrument.axis});
    if (now.taken) {
      tracks.back().tip.push_back(now.tip);
      tracks.back().turn.push_back(now.turn);
    }
    before = now.taken;
  }
  return tracks;
}

std::optional<SampleRange> workOf(const Attempt& attempt) {
  std::optional<SampleRange> work;
  for (std::size_t f = 0; f < attempt.time.size(); ++f) {
    const bool works = std::ranges::any_of(attempt.instruments,
                                           [&](const auto& one) { return one.moments[f].works; });
    if (!works) continue;
    if (!work) work = SampleRange{f, f};
    work->last = f;
  }
  return work;
}

double bleedingRate(const Attempt& attempt, std::size_t frame) {
  if (frame >= attempt.bled.size()) return 0;
  const auto second = std::size_t(std::llround(1 / attempt.interval));
  const std::size_t from = frame > second ? frame - second : 0;
  const double before = frame > second ? attempt.bled[from] : 0;
  const double span =
      frame > second ? attempt.time[frame] - attempt.time[from] : attempt.time[frame];
  return span > 0 ? (attempt.bled[frame] - before) / span : 0;
}

std::optional<std::size_t> worstBleeding(const Attempt& attempt) {
  std::optional<std::size_t> worst;
  double most = 0;
  for (std::size_t f = 0; f < attempt.bled.size(); ++f)
    if (const double rate = bleedingRate(attempt, f); rate > most) most = rate, worst = f;
  return worst;
}

}  // namespace resect

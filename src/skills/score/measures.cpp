#include "skills/score/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blood/bleeding.h"
#include "skills/metrics/force_figures.h"
#include "skills/metrics/movements.h"
#include "skills/metrics/path.h"
#include "skills/metrics/smoothness.h"
#include "skills/metrics/spectrum.h"
#include "skills/metrics/two_hands.h"

namespace resect {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

// A mean of values that weigh as long as they lasted.
struct TimedMean {
  double sum = 0, time = 0;
  void add(std::optional<double> value, double duration) {
    if (value) sum += *value * duration, time += duration;
  }
  std::optional<double> value() const {
    if (!(time > 0)) return {};
    return sum / time;
  }
};

// Sums over the tracks of one instrument, or of all.
struct Motion {
  bool inHand = false;
  double path = 0, depth = 0, rotation = 0, idle = 0;
  int movements = 0, turns = 0;
  Ways ways;
  TimedMean sparc, ldlj, frequency;

  void add(const Track& track) {
    inHand = inHand || track.tip.size() > 1;
    path += pathLength(track.tip);
    depth += depthMovement(track);
    rotation += totalRotation(track);
    idle += idleTime(track);
    const std::vector<double> speed = speeds(track);
    const std::vector<SampleRange> moves = resect::movements(speed, track.interval);
    movements += int(moves.size());
    turns += int(
        resect::movements(angularSpeeds(track), track.interval, {kRotationThreshold, 0.2}).size());
    addWays(ways, track, moves);
    for (const SampleRange& m : moves) {
      const auto profile = std::span(speed).subspan(m.first, m.count());
      const double duration = track.interval * double(m.count());
      sparc.add(spectralArcLength(profile, track.interval), duration);
      ldlj.add(logDimensionlessJerk(profile, track.interval), duration);
      frequency.add(frequency95(profile, track.interval), duration);
    }
  }
};

class Sheet {
 public:
  explicit Sheet(std::vector<Measured>& all) : all_(all) {}
  void of(std::string instrument) { instrument_ = std::move(instrument); }
  void put(const char* measure, double value) {
    if (std::isfinite(value)) all_.push_back({measure, instrument_, value});
  }
  void put(const char* measure, std::optional<double> value) {
    if (value) put(measure, *value);
  }

 private:
  std::vector<Measured>& all_;
  std::string instrument_;
};

void putMotion(Sheet& sheet, const Motion& m) {
  if (!m.inHand) return;
  sheet.put("path_length_m", m.path);
  sheet.put("path_inefficiency_pct", pathInefficiency(m.ways));
  sheet.put("movements", m.movements);
  sheet.put("rotation_deg", kDegrees * m.rotation);
  sheet.put("rotational_actions", m.turns);
  sheet.put("depth_m", m.depth);
  sheet.put("idle_s", m.idle);
  sheet.put("sparc", m.sparc.value());
  sheet.put("ldlj", m.ldlj.value());
  sheet.put("frequency95_hz", m.frequency.value());
}

std::vector<double> forcesOf(const InstrumentRecord& instrument) {
  std::vector<double> force;
  for (const ToolMoment& m : instrument.moments) force.push_back(m.inHand ? m.force : 0);
  return force;
}

struct Errors {
  int count = 0;
  double time = 0;
};

std::optional<ForceLimit> limitOf(const Attempt& attempt) {
  return attempt.task ? forceLimitOf(*attempt.task) : std::nullopt;
}

Errors errorsOf(const std::vector<double>& force, const Attempt& attempt) {
  Errors errors;
  const auto limit = limitOf(attempt);
  if (!limit) return errors;
  for (const SampleRange& range : forceErrors(force, limit->force)) {
    ++errors.count;
    errors.time += attempt.interval * double(range.count());
  }
  return errors;
}

void putForces(Sheet& sheet, const std::vector<double>& force, const Errors& errors,
               const Attempt& attempt) {
  const ForceFigures figures = forceFigures(force);
  sheet.put("force_peak_n", figures.peak);
  sheet.put("force_p95_n", figures.p95);
  sheet.put("force_mean_n", figures.mean);
  sheet.put("force_sd_n", figures.deviation);
  if (!limitOf(attempt)) return;
  sheet.put("force_errors", errors.count);
  sheet.put("force_error_s", errors.time);
}

void putInstruments(Sheet& sheet, const Attempt& attempt) {
  Motion all;
  std::vector<double> forces;
  Errors errors;
  std::optional<double> unseen;
  for (const InstrumentRecord& one : attempt.instruments) {
    Motion own;
    for (const Track& track : tracksOf(attempt, one)) own.add(track), all.add(track);
    if (!own.inHand) continue;
    sheet.of(one.name);
    putMotion(sheet, own);
    sheet.put("out_of_view_s", one.unseen);
    if (one.unseen) unseen = unseen.value_or(0) + *one.unseen;
    if (!attempt.tissueMoves) continue;
    const std::vector<double> force = forcesOf(one);
    const Errors mine = errorsOf(force, attempt);
    putForces(sheet, force, mine, attempt);
    forces.insert(forces.end(), force.begin(), force.end());
    errors.count += mine.count, errors.time += mine.time;
  }
  sheet.of("");
  putMotion(sheet, all);
  sheet.put("out_of_view_s", unseen);
  if (attempt.tissueMoves && all.inHand) putForces(sheet, forces, errors, attempt);
}

// Of the two instruments that were longest in hand together.
std::optional<double> handsTogether(const Attempt& attempt) {
  std::optional<double> best;
  std::size_t most = 60;  // frames
  const auto& tools = attempt.instruments;
  for (std::size_t a = 0; a < tools.size(); ++a)
    for (std::size_t b = a + 1; b < tools.size(); ++b) {
      std::vector<double> speedA, speedB;
      for (std::size_t f = 1; f < attempt.time.size(); ++f) {
        const ToolMoment &a0 = tools[a].moments[f - 1], &a1 = tools[a].moments[f];
        const ToolMoment &b0 = tools[b].moments[f - 1], &b1 = tools[b].moments[f];
        if (!(a0.taken && a1.taken && b0.taken && b1.taken)) continue;
        speedA.push_back((a1.tip - a0.tip).norm()), speedB.push_back((b1.tip - b0.tip).norm());
      }
      if (speedA.size() < most) continue;
      most = speedA.size();
      best = correlation(speedA, speedB);
    }
  return best;
}

void putVessels(Sheet& sheet, const Attempt& attempt) {
  int cut = 0, unsealed = 0, open = 0;
  std::optional<double> longest;  // until one was closed
  for (const VesselStory& v : attempt.vessels) {
    if (v.diameter < kNotableVessel || v.kind == VesselKind::BileDuct) continue;
    if (!v.before) ++cut;
    if (!v.before && !v.clippedRoot) ++unsealed;
    if (!v.closed && (!v.before || v.bled > kBleeds)) ++open;
    if (v.closed) longest = std::max(longest.value_or(0), *v.closed - v.cut);
  }
  sheet.put("vessels_cut", cut);
  sheet.put("vessels_unsealed", unsealed);
  sheet.put("vessels_open", open);
  // As long as one is open, there is no such time.
  if (open == 0) sheet.put("seal_time_s", longest);
  sheet.put("clips", double(attempt.clips.size()));
}

void putBlood(Sheet& sheet, const Attempt& attempt) {
  if (!attempt.bleeds || attempt.bled.empty()) return;
  const double rate = bleedingRate(attempt, attempt.bled.size() - 1);
  sheet.put("blood_loss_ml", 1e6 * attempt.bled.back());
  sheet.put("blood_rate_ml_min", 60e6 * rate);
  sheet.put("blood_grade", bleedingGrade(rate));
  putVessels(sheet, attempt);
  sheet.put("inflow_occluded_s", attempt.inflowOccluded);
  sheet.put("inflow_cycles", attempt.inflowCycles);
}

void putTissue(Sheet& sheet, const Attempt& attempt, std::optional<double> workTime) {
  if (attempt.tissue.empty()) return;
  const TissueMoment& end = attempt.tissue.back();
  if (!attempt.specimens.empty()) {
    sheet.put("specimen_ml", 1e6 * attempt.specimens[0].volume);
    sheet.put("specimen_g", 1e3 * attempt.specimens[0].mass);
  }
  sheet.put("removed_ml", 1e6 * end.removed);
  sheet.put("torn_bonds", double(attempt.torn));
  const double cut = 1e4 * (end.cut - attempt.tissue.front().cut);  // cm^2, by the learner
  sheet.put("cut_cm2", cut);
  if (cut > 0 && workTime && *workTime > 0) sheet.put("cut_speed_cm2_min", cut / (*workTime / 60));
  if (cut > 0 && attempt.bleeds && !attempt.bled.empty())
    sheet.put("blood_ml_cm2", 1e6 * attempt.bled.back() / cut);
}

}  // namespace

std::vector<Measured> measuresOf(const Attempt& attempt) {
  std::vector<Measured> all;
  Sheet sheet(all);
  std::optional<double> workTime;
  if (const auto work = workOf(attempt)) {
    workTime = attempt.interval * double(work->count());
    sheet.put("time_s", *workTime);
  }
  sheet.put("total_time_s", attempt.duration());
  putInstruments(sheet, attempt);
  sheet.put("hands_correlation", handsTogether(attempt));
  putBlood(sheet, attempt);
  putTissue(sheet, attempt, workTime);
  if (attempt.otherStructures) sheet.put("structures_hurt", double(attempt.hurt.size()));
  sheet.put("undos", attempt.undos);
  return all;
}

std::optional<double> valueOf(std::span<const Measured> all, std::string_view measure,
                              std::string_view instrument) {
  for (const Measured& one : all)
    if (one.measure == measure && one.instrument == instrument) return one.value;
  return {};
}

}  // namespace resect

#include "skills/score/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "operation/task/measure.h"

namespace resect {
namespace {

struct Advice {
  const char* measure;
  const char* question;
  const char* next;
};

constexpr const char* kQuicker =
    "Play the attempt back on the timeline, find where the hand waited or searched, and plan that "
    "step before you begin again.";

// By measure, in the order of their weight.
constexpr Advice kAdvice[] = {
    {"vessels_unsealed", "How could the vessel have been seen before it was cut?",
     "Look for the vessel first, close it, and cut it then."},
    {"vessels_open", "What shows that a vessel still bleeds?",
     "Look at the wound for a while before you leave it."},
    {"blood_loss_ml", "What was in the way of closing the vessel earlier?",
     "Press on it or suck it dry, see where it bleeds, and close that at once."},
    {"blood_rate_ml_min", "Where does this blood come from?",
     "Clear the wound and look for the last source."},
    {"bleeding_s", "Which step took longest between the cut and the closed vessel?",
     "Have the clip ready before the wound is cleared."},
    {"seal_time_s", "What was done between the cut and the clip?",
     "Close a vessel before the next step."},
    {"structures_hurt", "How could this structure have been seen, or held out of the way?",
     "Find what lies near before you cut, and keep it in sight."},
    {"margin_mm", "How was the distance from the target judged while cutting?",
     "Mark the margin on the surface before the first cut."},
    {"target_left_ml", "Where was the target expected?",
     "Begin farther out, and turn in only below the target."},
    {"off_plane_most_mm", "What did you look at to keep the plane?",
     "Set a mark at both ends of the plane and cut from one to the other."},
    {"off_plane_mm", "What did you look at to keep the plane?",
     "Set a mark at both ends of the plane and cut from one to the other."},
    {"off_line_most_mm", "What happened there?", "Slow down where the line turns."},
    {"off_line_mm", "Where did the eyes rest while cutting?",
     "Look a centimetre ahead of the blade."},
    {"line_covered_pct", "Where was the line hard to reach?",
     "Go over the whole line in the air once before cutting."},
    {"held_pct", "What would have kept the tissue under tension?",
     "Take hold first, pull a little, and only then cut."},
    {"force_peak_n", "What did the tissue look like at that moment?",
     "Watch how far the tissue gives way, and stop when it whitens or tents."},
    {"force_errors", "What did the tissue look like at these moments?",
     "Watch how far the tissue gives way, and stop when it whitens or tents."},
    {"force_error_s", "What did the tissue look like at these moments?",
     "Watch how far the tissue gives way, and stop when it whitens or tents."},
    {"torn_bonds", "What pulled the tissue apart?", "Cut what is under tension, do not tear it."},
    {"removed_ml", "Which tissue need not have been touched?",
     "Plan the way in before the first cut."},
    {"drift_mm", "What moved while the target was held?", "Rest the hand before you hold."},
    {"targets_held", "How was the depth of the target judged?",
     "Come from the side in which depth can be seen."},
    {"sparc", "When was the hand not steady?", "Move in one go, and rest the hand between."},
    {"ldlj", "When was the hand not steady?", "Move in one go, and rest the hand between."},
    {"path_length_m", "Which way was not needed?", "Bring the tip in on one straight way."},
    {"movements", "Which movements were searches?", "Look where to go before you move."},
    {"out_of_view_s", "What was the instrument doing while nobody saw it?",
     "Bring the tip into the picture before you move it, and turn the view with it."},
    {"idle_s", "What were you waiting for?", "Say the next step aloud before the last one ends."},
    {"time_s", "Which step took longest?", kQuicker},
    {"total_time_s", "Which step took longest?", kQuicker},
};

// Measures that add up while work goes on, and those of a bleeding that is to be stopped first.
constexpr std::string_view kAmounts[] = {"time_s",
                                         "total_time_s",
                                         "path_length_m",
                                         "movements",
                                         "rotation_deg",
                                         "depth_m",
                                         "idle_s",
                                         "out_of_view_s",
                                         "structures_hurt",
                                         "rotational_actions",
                                         "force_errors",
                                         "force_error_s",
                                         "blood_loss_ml",
                                         "blood_rate_ml_min",
                                         "blood_grade",
                                         "vessels_cut",
                                         "vessels_open",
                                         "vessels_unsealed",
                                         "clips",
                                         "seal_time_s",
                                         "inflow_occluded_s",
                                         "inflow_cycles",
                                         "specimen_ml",
                                         "specimen_g",
                                         "removed_ml",
                                         "torn_bonds",
                                         "cut_cm2",
                                         "undos"};

const Advice* adviceFor(std::string_view measure) {
  const auto at =
      std::ranges::find_if(kAdvice, [&](const Advice& a) { return a.measure == measure; });
  return at == std::end(kAdvice) ? nullptr : at;
}

std::size_t weightOf(std::string_view measure) {
  const Advice* advice = adviceFor(measure);
  return advice ? std::size_t(advice - kAdvice) : std::size(kAdvice);
}

// An amount of blood, ml: small ones with a decimal.
std::string bloodText(double volume) {
  const double ml = 1e6 * volume;
  return ml < 10 ? fmt::format("{:.1f}", ml) : fmt::format("{:.0f}", ml);
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text;
}

std::string gapText(const Check& check) {
  const MeasureKind& kind = *findMeasure(check.measure);
  const std::string unit = kind.unit.empty() || !check.value ? "" : fmt::format(" {}", kind.unit);
  return fmt::format("{}: {}{}, wanted {}.", capitalised(std::string(kind.title)), valueText(check),
                     unit, limitText(check));
}

struct Peak {
  double force = 0;
  std::size_t frame = 0;
  const InstrumentRecord* instrument = nullptr;
};

Peak peakOf(const Attempt& attempt) {
  Peak peak;
  for (const InstrumentRecord& one : attempt.instruments)
    for (std::size_t f = 0; f < one.moments.size(); ++f)
      if (one.moments[f].inHand && one.moments[f].force > peak.force)
        peak = {one.moments[f].force, f, &one};
  return peak;
}

// A fact about forces: when and with what the largest one was.
void tellForce(const Attempt& attempt, Deduction& d) {
  const Peak peak = peakOf(attempt);
  if (!peak.instrument) return;
  d.time = attempt.time[peak.frame];
  d.fact +=
      fmt::format(" The largest force was {:.1f} N on the {}.", peak.force, peak.instrument->name);
}

const VesselStory* worstOf(const Attempt& attempt) {
  const auto at = std::ranges::max_element(attempt.vessels, {}, &VesselStory::bled);
  return at == attempt.vessels.end() || !(at->bled > 0) ? nullptr : &*at;
}

std::string vesselText(const VesselStory& v) {
  return fmt::format("{} of {:.1f} mm", v.name, 1e3 * v.diameter);
}

void tellBlood(const Attempt& attempt, Deduction& d) {
  const VesselStory* worst = worstOf(attempt);
  if (!worst) return;
  if (!worst->before) d.time = worst->cut;
  const bool most = !attempt.bled.empty() && worst->bled > 0.5 * attempt.bled.back();
  d.fact += fmt::format(" {}, {} ml, came from the {} that {}.",
                        most ? "Most of the blood" : "The largest share of one vessel",
                        bloodText(worst->bled), vesselText(*worst),
                        worst->before ? std::string("was cut from the start")
                                      : fmt::format("was cut at {}", timeText(worst->cut)));
}

void tellOff(const Attempt& attempt, Deduction& d) {
  const auto worst = std::ranges::max_element(attempt.goal.work, {}, &WorkMoment::off);
  if (worst == attempt.goal.work.end()) return;
  d.time = attempt.time[worst->frame];
}

// The longest stretch within a range of frames in which no instrument touched or cut the organ.
SampleRange longestWait(const Attempt& attempt, std::size_t first, std::size_t last) {
  SampleRange longest{first, first}, now{first, first};
  for (std::size_t f = first; f <= last && f < attempt.time.size(); ++f) {
    const bool works = std::ranges::any_of(
        attempt.instruments, [&](const InstrumentRecord& one) { return one.moments[f].works; });
    if (works) now.first = f + 1;
    now.last = f;
    if (!works && now.last - now.first > longest.last - longest.first) longest = now;
  }
  return longest;
}

// Where time was lost: the longest wait, if it was long.
void tellWait(const Attempt& attempt, Deduction& d, bool bleeding) {
  constexpr double kLong = 2;  // s
  if (attempt.time.empty()) return;
  std::size_t first = 0, last = attempt.time.size() - 1;
  if (bleeding) {
    const double rate = attempt.task->goal.rate;
    while (last > 0 && bleedingRate(attempt, last) < rate) --last;
  } else if (const auto work = workOf(attempt)) {
    first = work->first, last = work->last;
  }
  const SampleRange wait = longestWait(attempt, first, last);
  const double length = attempt.interval * double(wait.count());
  if (length < kLong) return;
  d.time = attempt.time[wait.first];
  const std::string from = timeText(attempt.time[wait.first]);
  d.fact += bleeding ? fmt::format(
                           " For {:.0f} s from {} on no instrument touched the organ, while it "
                           "bled at {:.0f} ml/min.",
                           length, from, 60e6 * bleedingRate(attempt, (wait.first + wait.last) / 2))
                     : fmt::format(" For {:.0f} s from {} on no instrument touched the organ.",
                                   length, from);
}

void tellHurt(const Attempt& attempt, Deduction& d) {
  for (const std::string& name : attempt.hurt) d.fact += fmt::format(" The {} was hurt.", name);
}

Deduction findingFor(const Attempt& attempt, const Check& check) {
  const Advice* advice = adviceFor(check.measure);
  Deduction d{check.measure,
              {},
              gapText(check),
              advice ? advice->question : "What led to this?",
              advice ? advice->next : "Watch this figure in the next attempt."};
  if (check.measure.starts_with("force_")) tellForce(attempt, d);
  if (check.measure.starts_with("blood_")) tellBlood(attempt, d);
  if (check.measure == "bleeding_s" || (check.measure == "blood_loss_ml" && !d.time))
    tellWait(attempt, d, true);
  if (check.measure == "time_s" || check.measure == "total_time_s") tellWait(attempt, d, false);
  if (check.measure.starts_with("off_")) tellOff(attempt, d);
  if (check.measure == "structures_hurt") tellHurt(attempt, d);
  return d;
}

// Each vessel that was cut before it was closed, the worst three.
std::vector<Deduction> vesselFindings(const Attempt& attempt) {
  std::vector<const VesselStory*> cut;
  for (const VesselStory& v : attempt.vessels)
    if (!v.before && v.diameter >= kNotableVessel && v.kind != VesselKind::BileDuct &&
        !v.clippedRoot)
      cut.push_back(&v);
  std::ranges::stable_sort(cut, std::greater<>(), &VesselStory::bled);
  cut.resize(std::min<std::size_t>(cut.size(), 3));
  std::vector<Deduction> found;
  const Advice& advice = *adviceFor("vessels_unsealed");
  for (const VesselStory* v : cut) {
    const std::string since = v->closed ? fmt::format("closed {:.1f} s later", *v->closed - v->cut)
                                        : std::string("still open at the end");
    found.push_back({"vessels_unsealed", v->cut,
                     capitalised(fmt::format("{} cut unclipped, {} ml lost, {}.", vesselText(*v),
                                             bloodText(v->bled), since)),
                     advice.question, advice.next});
  }
  return found;
}

// What to try after a goal that was missed: the step after those for which instruments were used.
std::string nextTime(const Attempt& attempt) {
  const Task& task = *attempt.task;
  if (task.goal.kind == TaskGoal::Kind::Touch)
    return "Turn the view until the depth of the target can be seen, then bring the tip in.";
  if (task.steps.empty()) return "Do the task's steps one after the other.";
  const auto used = std::ranges::count_if(attempt.instruments, [](const InstrumentRecord& one) {
    return std::ranges::any_of(one.moments, &ToolMoment::works);
  });
  return task.steps[std::min(std::size_t(used), task.steps.size() - 1)];
}

}  // namespace

std::vector<Deduction> findings(const Attempt& attempt, const GoalResult& goal,
                                const std::vector<Check>& checks) {
  std::vector<Deduction> found;
  if (!goal.reached)
    found.push_back(
        {"", goal.time, goal.sentence, "What would have been the next step?", nextTime(attempt)});
  std::vector<Check> failed;
  std::ranges::copy_if(checks, std::back_inserter(failed), [](const Check& c) { return !c.kept; });
  std::ranges::stable_sort(failed, {}, [](const Check& c) { return weightOf(c.measure); });
  for (const Check& check : failed) {
    if (ranOut(check, goal)) continue;
    if (check.measure == "vessels_unsealed")
      for (Deduction& one : vesselFindings(attempt)) found.push_back(std::move(one));
    else
      found.push_back(findingFor(attempt, check));
  }
  return found;
}

bool addsUp(std::string_view measure) { return std::ranges::count(kAmounts, measure) > 0; }

std::vector<std::string> praise(const Attempt& attempt, const GoalResult& goal,
                                const std::vector<Check>& checks) {
  std::vector<std::string> good;
  if (goal.reached) good.push_back(goal.sentence);
  if (!goal.reached && !workOf(attempt)) return good;
  for (const Check& check : checks)
    if (check.kept && (goal.reached || !addsUp(check.measure))) good.push_back(gapText(check));
  if (attempt.undos == 0 && attempt.task->undo == false) good.push_back("Nothing was taken back.");
  return good;
}

bool ranOut(const Check& check, const GoalResult& goal) {
  return !goal.reached && !check.kept && check.measure == "total_time_s" && check.most &&
         check.value && *check.value > *check.most;
}

std::string valueText(const Check& check) {
  if (!check.value) return "never";
  const std::string text = numberText(*check.value);
  const auto looksLike = [&](std::optional<double> limit) {
    return limit && *limit != *check.value && numberText(*limit) == text;
  };
  const bool unclear = !check.kept && (looksLike(check.least) || looksLike(check.most));
  return unclear ? fmt::format("{:.6g}", *check.value) : text;
}

std::string numberText(double value) {
  if (std::abs(value) < 1e-9) return "0";  // rounding
  const double size = std::abs(value);
  if (size >= 1000) return fmt::format("{:.0f}", value);
  return fmt::format("{:.3g}", value);
}

std::string measureText(std::string_view measure, double value) {
  const MeasureKind* kind = findMeasure(measure);
  const std::string number = numberText(value);
  return kind && !kind->unit.empty() ? fmt::format("{} {}", number, kind->unit) : number;
}

std::string limitText(const Check& check) {
  const auto text = [&](double v) { return measureText(check.measure, v); };
  if (check.least && check.most)
    return fmt::format("{} to {}", numberText(*check.least), text(*check.most));
  if (check.most) return "at most " + text(*check.most);
  return check.least ? "at least " + text(*check.least) : "any";
}

std::string timeText(double seconds) {
  const auto tenths = std::llround(seconds * 10);
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

}  // namespace resect

#include "skills/report/report_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

#include "base/text/printed_time.h"
#include "operation/task/measure.h"
#include "skills/score/findings.h"

namespace resect {
namespace {

using Json = nlohmann::ordered_json;

Json numberOrNull(std::optional<double> value) {
  return value ? Json(printed(*value)) : Json(nullptr);
}

Json toJson(const Check& check) {
  return {{"measure", check.measure},
          {"value", numberOrNull(check.value)},
          {"least", numberOrNull(check.least)},
          {"most", numberOrNull(check.most)},
          {"kept", check.kept},
          {"counts", check.counts},
          {"source", check.source}};
}

Json toJson(const Deduction& d) {
  return {{"measure", d.measure},
          {"time_s", d.time ? Json(printedTime(*d.time)) : Json(nullptr)},
          {"fact", d.fact},
          {"question", d.question},
          {"next", d.next}};
}

Json toJson(const VesselStory& v) {
  return {{"vessel", v.name},
          {"diameter_mm", printed(1e3 * v.diameter)},
          {"place_at_rest_m", {printed(v.place.x()), printed(v.place.y()), printed(v.place.z())}},
          {"cut_s", printedTime(v.cut)},
          {"clipped_before", v.clippedRoot},
          {"severed", v.severed},
          {"closed_s", v.closed ? Json(printedTime(*v.closed)) : Json(nullptr)},
          {"bled_ml", printed(1e6 * v.bled)}};
}

Json measuresJson(const Scored& scored) {
  Json json;
  for (const Measured& m : scored.measures)
    (m.instrument.empty() ? json["whole"] : json["instruments"][m.instrument])[m.measure] =
        printed(m.value);
  return json;
}

}  // namespace

double printed(double value) {
  if (!std::isfinite(value) || std::abs(value) < 1e-9) return 0;  // rounding
  const std::string text = fmt::format("{:.6g}", value);
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

Json toJson(const Scored& scored) {
  const Attempt& attempt = scored.attempt;
  const Verdict& verdict = scored.verdict;
  Json json{{"file", attempt.file},
            {"scenario", attempt.scenario},
            {"title", attempt.title},
            {"learner", attempt.learner},
            {"program", attempt.program},
            {"complete", attempt.complete},
            {"level", wordOf(scored.level)},
            {"goal", goalSentence(*attempt.task)},
            {"goal_reached", verdict.goal.reached},
            {"passed", verdict.passed},
            {"graded", verdict.graded},
            {"score", printed(verdict.score)},
            {"reason", verdict.reason}};
  json["checks"] = Json::array();
  for (const Check& check : verdict.checks) json["checks"].push_back(toJson(check));
  json["deductions"] = Json::array();
  for (const Deduction& d : verdict.deductions) json["deductions"].push_back(toJson(d));
  json["good"] = verdict.good;
  json["measures"] = measuresJson(scored);
  json["places_m"] = Json::array();  // where the goal was when work began
  for (const Vec3& p : attempt.goal.places)
    json["places_m"].push_back({printed(p.x()), printed(p.y()), printed(p.z())});
  json["vessels"] = Json::array();
  for (const VesselStory& v : attempt.vessels) json["vessels"].push_back(toJson(v));
  return json;
}

void writeAttemptRows(CsvWriter& csv, std::span<const Scored> attempts) {
  csv.cell("file").cell("scenario").cell("learner").cell("level").cell("graded").cell("passed");
  csv.cell("goal_reached").cell("score").cell("undos_used");
  for (const MeasureKind& kind : measureKinds()) csv.cell(kind.id);
  csv.end();
  for (const Scored& s : attempts) {
    const auto flag = [](bool yes) { return std::string_view(yes ? "yes" : "no"); };
    csv.cell(s.attempt.file).cell(s.attempt.scenario).cell(s.attempt.learner);
    csv.cell(wordOf(s.level)).cell(flag(s.verdict.graded)).cell(flag(s.verdict.passed));
    csv.cell(flag(s.verdict.goal.reached)).cell(printed(s.verdict.score));
    csv.cell(flag(s.attempt.undos > 0));
    for (const MeasureKind& kind : measureKinds()) {
      if (const auto value = valueOf(s.measures, kind.id))
        csv.cell(printed(*value));
      else
        csv.empty();
    }
    csv.end();
  }
}

void writeSampleRows(CsvWriter& csv, const Attempt& attempt) {
  csv.row("time_s", "instrument", "tip_x_m", "tip_y_m", "tip_z_m", "turn_w", "turn_x", "turn_y",
          "turn_z", "force_n", "squeeze", "pedal");
  for (std::size_t f = 0; f < attempt.time.size(); ++f)
    for (const InstrumentRecord& one : attempt.instruments) {
      const ToolMoment& m = one.moments[f];
      if (!m.taken) continue;
      csv.row(printedTime(attempt.time[f]), std::string_view(one.name), m.tip.x(), m.tip.y(),
              m.tip.z(), m.turn.w(), m.turn.x(), m.turn.y(), m.turn.z(), m.force, m.squeeze,
              m.pedal);
    }
}

}  // namespace resect

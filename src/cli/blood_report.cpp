#include "cli/blood_report.h"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace resect {
namespace {

double ml(Picolitres volume) { return 1e6 * toCubicMetres(volume); }
double mlPerMinute(double rate) { return 60e6 * rate; }

constexpr std::size_t kMostNamed = 3;  // vessels in the text

}  // namespace

nlohmann::ordered_json toJson(const BloodSummary& summary) {
  const BloodLedger& l = summary.ledger;
  nlohmann::ordered_json json = {{"bled_ml", ml(l.bled)},
                                 {"film_ml", ml(l.film)},
                                 {"clotted_ml", ml(l.clotted)},
                                 {"drops_ml", ml(l.drops)},
                                 {"pools_ml", ml(l.pools)},
                                 {"sucked_ml", ml(l.sucked)},
                                 {"absorbed_ml", ml(l.absorbed)},
                                 {"lost_ml", ml(l.lost)},
                                 {"unexplained_pl", l.bled - l.found()},
                                 {"rate_ml_min", mlPerMinute(summary.rate)},
                                 {"highest_rate_ml_min", mlPerMinute(summary.highest)},
                                 {"vibe", bleedingGrade(summary.rate)},
                                 {"air_ml", 1e6 * summary.air},
                                 {"clips", summary.clips},
                                 {"sealed", summary.sealed},
                                 {"inflow_clamped_s", summary.inflowClamped},
                                 {"vessels", nlohmann::ordered_json::array()},
                                 {"bare", nlohmann::ordered_json::array()}};
  const auto list = [](const Vec3& v) { return nlohmann::ordered_json{v.x(), v.y(), v.z()}; };
  for (const CutVesselSummary& v : summary.vessels)
    json["vessels"].push_back({{"kind", wordOf(v.kind)},
                               {"name", v.name},
                               {"diameter_mm", 1e3 * v.diameter},
                               {"severed", v.severed},
                               {"closed", v.closed},
                               {"bled_ml", 1e6 * v.bled},
                               {"rate_ml_min", mlPerMinute(v.flow)},
                               {"vibe", bleedingGrade(v.flow)},
                               {"place", list(v.place)}});
  for (const BareVesselSummary& v : summary.bare)
    json["bare"].push_back({{"kind", wordOf(v.kind)},
                            {"name", v.name},
                            {"diameter_mm", 1e3 * v.diameter},
                            {"place", list(v.place)},
                            {"along", list(v.along)},
                            {"length_mm", 1e3 * v.length},
                            {"divided", v.divided},
                            {"closures", v.closures}});
  return json;
}

std::string toText(const BloodSummary& summary) {
  const BloodLedger& l = summary.ledger;
  std::string text = fmt::format(
      "  {:<10} {:.1f} ml bled, now {:.0f} ml/min (grade {} of 4): {:.1f} ml on organs, {:.1f} ml "
      "clotted, {:.1f} ml in pools\n",
      "blood", ml(l.bled), mlPerMinute(summary.rate), bleedingGrade(summary.rate),
      ml(l.film + l.drops), ml(l.clotted), ml(l.pools));
  double fromVessels = 0;
  for (const CutVesselSummary& v : summary.vessels) fromVessels += std::max(0.0, v.flow);
  if (mlPerMinute(summary.rate) >= 0.5)
    text +=
        fmt::format("  {:<10} of this rate, {:.0f} ml/min come from cut vessels, the rest oozes\n",
                    "", mlPerMinute(std::min(fromVessels, summary.rate)));
  if (ml(l.lost) >= 0.05)
    text += fmt::format("  {:<10} {:.1f} ml have run off the table\n", "", ml(l.lost));
  if (l.sucked > 0 || l.absorbed > 0)
    text += fmt::format("  {:<10} {:.1f} ml sucked, {:.1f} ml in gauze\n", "", ml(l.sucked),
                        ml(l.absorbed));
  if (summary.air > 1e-9)
    text +=
        fmt::format("  {:<10} {:.1f} ml of air drawn into hepatic veins\n", "", 1e6 * summary.air);
  if (summary.inflowClamped > 0)
    text += fmt::format("  {:<10} {:.0f} s clamped\n", "inflow", summary.inflowClamped);
  if (summary.clips > 0) text += fmt::format("  {:<10} {} on vessels\n", "clips", summary.clips);
  if (summary.sealed > 0)
    text += fmt::format("  {:<10} {} vessels closed by heat\n", "heat", summary.sealed);
  std::string named;
  for (std::size_t i = 0; i < summary.vessels.size() && i < kMostNamed; ++i)
    named += fmt::format("{}{} of {:.1f} mm", i ? ", " : "", summary.vessels[i].name,
                         1e3 * summary.vessels[i].diameter);
  if (!named.empty())
    text +=
        fmt::format("  {:<10} {} cut, the widest: {}\n", "vessels", summary.vessels.size(), named);
  return text;
}

nlohmann::ordered_json toJson(const std::vector<SegmentAmount>& segments) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SegmentAmount& s : segments)
    json.push_back({{"segment", romanNumber(s.segment)},
                    {"before_ml", 1e6 * s.before},
                    {"body_ml", 1e6 * s.body}});
  return json;
}

std::string toText(const std::vector<SegmentAmount>& segments) {
  std::string parted;
  for (const SegmentAmount& s : segments)
    if (s.before - s.body >= 1e-6)
      parted += fmt::format("{}{:.0f} of {:.0f} ml of {}", parted.empty() ? "" : ", ",
                            1e6 * (s.before - s.body), 1e6 * s.before, romanNumber(s.segment));
  return parted.empty() ? "" : fmt::format("  {:<10} removed or parted: {}\n", "segments", parted);
}

}  // namespace resect

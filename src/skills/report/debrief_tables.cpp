#include "skills/report/debrief_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "operation/task/measure.h"
#include "skills/report/chart.h"
#include "skills/report/html.h"
#include "skills/score/findings.h"

namespace resect {
namespace {

HtmlCell number(const std::string& text, const char* style = "number") {
  return {htmlText(text), style};
}
HtmlCell text(std::string_view plain) { return {htmlText(plain)}; }

std::string valueText(const Scored& scored, std::string_view measure,
                      std::string_view instrument = "") {
  const auto value = valueOf(scored.measures, measure, instrument);
  return value ? numberText(*value) : "";
}

// Mean of a measure over the references.
std::string referenceText(std::span<const Scored> references, std::string_view measure) {
  double sum = 0;
  int count = 0;
  for (const Scored& one : references)
    if (const auto value = valueOf(one.measures, measure)) sum += *value, ++count;
  return count > 0 ? numberText(sum / count) : "";
}

// Median of a measure over the attempts of the others.
std::string classText(std::span<const ClassAttempt> others, std::string_view measure) {
  std::vector<double> values;
  for (const ClassAttempt& one : others)
    if (const auto value = valueOf(one.measures, measure)) values.push_back(*value);
  if (values.empty()) return "";
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return numberText(values.size() % 2 == 1 ? values[half]
                                           : 0.5 * (values[half - 1] + values[half]));
}

// All of the learner's attempts, the oldest first.
std::vector<ClassAttempt> ownAttempts(const Debrief& debrief) {
  std::vector<ClassAttempt> all = debrief.earlier;
  for (const Scored& one : debrief.attempts) all.push_back(classAttempt(one));
  return all;
}

const Check* checkOf(const Verdict& verdict, std::string_view measure) {
  const auto at = std::ranges::find(verdict.checks, measure, &Check::measure);
  return at == verdict.checks.end() ? nullptr : &*at;
}

std::vector<std::string> instrumentsIn(const Scored& scored) {
  std::vector<std::string> names;
  for (const Measured& m : scored.measures)
    if (!m.instrument.empty() && std::ranges::count(names, m.instrument) == 0)
      names.push_back(m.instrument);
  return names;
}

std::string wholeTable(const Debrief& debrief) {
  const Scored& last = debrief.attempts.back();
  const std::vector<ClassAttempt> own = ownAttempts(debrief);
  const ClassAttempt* before = own.size() > 1 ? &own[own.size() - 2] : nullptr;
  HtmlTable table;
  table.head = {text("measure"), number("this attempt"), text("unit"), text("wanted")};
  if (before) table.head.push_back(number("attempt before"));
  if (!debrief.others.empty()) table.head.push_back(number("class, median"));
  if (!debrief.references.empty()) table.head.push_back(number("reference"));
  for (const MeasureKind& kind : measureKinds()) {
    const Check* check = checkOf(last.verdict, kind.id);
    const std::string value = check ? valueText(*check) : valueText(last, kind.id);
    if (value.empty()) continue;
    const char* style = !check ? "number" : check->kept ? "number kept" : "number missed";
    std::vector<HtmlCell> row{text(kind.title), number(value, style), text(kind.unit),
                              text(check ? limitText(*check) : "")};
    if (before) {
      const auto then = valueOf(before->measures, kind.id);
      row.push_back(number(then ? numberText(*then) : ""));
    }
    if (!debrief.others.empty()) row.push_back(number(classText(debrief.others, kind.id)));
    if (!debrief.references.empty())
      row.push_back(number(referenceText(debrief.references, kind.id)));
    table.rows.push_back(std::move(row));
  }
  return toHtml(table);
}

std::string instrumentTable(const Scored& scored) {
  const std::vector<std::string> names = instrumentsIn(scored);
  if (names.size() < 2) return "";
  HtmlTable table;
  table.head = {text("by instrument")};
  for (const std::string& name : names) table.head.push_back(number(name));
  table.head.push_back(text("unit"));
  for (const MeasureKind& kind : measureKinds()) {
    if (kind.of == MeasureKind::Of::Whole) continue;
    std::vector<HtmlCell> row{text(kind.title)};
    bool any = false;
    for (const std::string& name : names) {
      row.push_back(number(valueText(scored, kind.id, name)));
      any = any || !row.back().html.empty();
    }
    row.push_back(text(kind.unit));
    if (any) table.rows.push_back(std::move(row));
  }
  return toHtml(table);
}

}  // namespace

std::string figureTable(const Debrief& debrief) {
  return wholeTable(debrief) + instrumentTable(debrief.attempts.back());
}

std::string studyTable(std::span<const PublishedStudy> studies, std::span<const Measured> own) {
  std::string html;
  for (const PublishedStudy& study : studies) {
    HtmlTable table;
    table.head = {text("published"), text("group"), number("mean"), number("deviation")};
    if (!own.empty()) table.head.insert(table.head.begin() + 1, number("this attempt"));
    for (const PublishedBand& band : study.bands)
      for (const PublishedBand::Group& group : band.groups) {
        std::vector<HtmlCell> row{text(findMeasure(band.measure)->title), text(group.name),
                                  number(measureText(band.measure, group.mean)),
                                  number(group.deviation > 0 ? numberText(group.deviation) : "")};
        const auto value = valueOf(own, band.measure);
        if (!own.empty()) row.insert(row.begin() + 1, number(value ? numberText(*value) : ""));
        table.rows.push_back(std::move(row));
      }
    html +=
        fmt::format("<p class=\"quiet\">{}: {} <a href=\"{}\">{}</a></p>\n", htmlText(study.study),
                    htmlText(study.about), htmlText(study.source), htmlText(study.source)) +
        toHtml(table);
  }
  return html;
}

std::string vesselSection(const Attempt& attempt) {
  HtmlTable table;
  table.head = {text("vessel"), number("mm"),           number("cut at"), text("clipped before"),
                text("cut"),    number("closed after"), number("ml lost")};
  int thin = 0;
  double thinBled = 0;
  for (const VesselStory& v : attempt.vessels) {
    if (v.diameter < kNotableVessel) {
      ++thin;
      thinBled += v.bled;
      continue;
    }
    table.rows.push_back({text(v.name),
                          number(fmt::format("{:.1f}", 1e3 * v.diameter)),
                          number(v.before ? "before the start" : timeText(v.cut)),
                          {v.clippedRoot ? "yes" : "no", v.clippedRoot ? "kept" : "missed"},
                          text(v.severed ? "through" : "in part"),
                          number(v.closed ? fmt::format("{:.1f} s", *v.closed - v.cut) : "open"),
                          number(fmt::format("{:.1f}", 1e6 * v.bled))});
  }
  if (attempt.vessels.empty()) return "";
  std::string html = table.rows.empty() ? std::string() : toHtml(table);
  if (thin > 0)
    html += fmt::format(
        "<p>{} vessels thinner than {:g} mm were cut besides; they lost {:.1f} "
        "ml.</p>\n",
        thin, 1e3 * kNotableVessel, 1e6 * thinBled);
  return htmlSection("Vessels that were cut", html);
}

std::string ledgerTable(const Attempt& attempt) {
  HtmlTable table;
  table.head = {text("what"), number("amount"), text("unit")};
  const auto row = [&](std::string_view what, double amount, const char* unit) {
    table.rows.push_back({text(what), number(numberText(amount)), text(unit)});
  };
  if (!attempt.tissue.empty()) {
    const TissueMoment &start = attempt.tissue.front(), &end = attempt.tissue.back();
    row("tissue before", 1e6 * (start.body + start.pieces + start.removed), "ml");
    row("what remains of the organs", 1e6 * end.body, "ml");
    row("pieces that came off", 1e6 * end.pieces, "ml");
    row("destroyed", 1e6 * end.removed, "ml");
    if (start.cut > 0) row("area cut before the start", 1e4 * start.cut, "cm2");
    row("area cut", 1e4 * (end.cut - start.cut), "cm2");
  }
  for (const Specimen& piece : attempt.specimens) row("a piece of", 1e6 * piece.volume, "ml");
  if (attempt.targetBefore > 0) row("target before", 1e6 * attempt.targetBefore, "ml");
  if (attempt.bleeds && !attempt.bled.empty()) row("blood lost", 1e6 * attempt.bled.back(), "ml");
  return toHtml(table);
}

std::string historySection(const Debrief& debrief) {
  const std::vector<ClassAttempt> all = ownAttempts(debrief);
  if (all.size() < 2) return "";
  HtmlTable table;
  table.head = {number("attempt"), text("result"),    number("score"),
                number("time, s"), number("path, m"), text("reason")};
  TimeChart chart{"Score", "%", double(all.size()), {{"", "#2166a5", {}}}, {}, {}, ""};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ClassAttempt& one = all[i];
    const auto figure = [&](const char* measure) {
      const auto value = valueOf(one.measures, measure);
      return number(value ? numberText(*value) : "");
    };
    table.rows.push_back({number(fmt::format("{}", i + 1)),
                          {!one.graded  ? "for practice"
                           : one.passed ? "passed"
                                        : "not passed",
                           !one.graded  ? "quiet"
                           : one.passed ? "kept"
                                        : "missed"},
                          number(fmt::format("{:.0f} %", 100 * one.score)),
                          figure("time_s"),
                          figure("path_length_m"),
                          text(one.reason)});
    chart.curves[0].points.emplace_back(double(i + 1), 100 * one.score);
  }
  std::string html = "<figure class=\"wide\">" + toSvg(chart) + "</figure>\n" + toHtml(table);
  if (!debrief.others.empty()) {
    const auto passed = std::ranges::count(debrief.others, true, &ClassAttempt::passed);
    html += fmt::format("<p class=\"quiet\">The others of the class: {} attempts, {} passed.</p>\n",
                        debrief.others.size(), passed);
  }
  return htmlSection("All attempts", html);
}

}  // namespace resect

#include "skills/report/debrief.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "operation/task/measure.h"
#include "skills/report/debrief_charts.h"
#include "skills/report/debrief_tables.h"
#include "skills/report/html.h"
#include "skills/score/findings.h"

namespace resect {
namespace {

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (int k = 0; k < 4; ++k)
      text += i + std::size_t(k) > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
  }
  return text;
}

// An MP4 file as <video>, or nothing if there are no bytes.
std::string htmlClip(const std::string& mp4, std::string_view about) {
  if (mp4.empty()) return "";
  return fmt::format(
      "<video controls muted loop preload=\"metadata\" aria-label=\"{}\" "
      "src=\"data:video/mp4;base64,{}\"></video>",
      htmlText(about), base64(mp4));
}

std::string verdictWord(const Verdict& verdict) {
  const char* word = verdict.passed ? "Passed" : "Not passed";
  return verdict.graded
             ? word
             : fmt::format("First attempt, for practice: it does not count, and would {}",
                           verdict.passed ? "have passed" : "not have passed");
}

std::string goodThings(const Verdict& verdict) {
  if (verdict.good.empty()) return "<p>The attempt was recorded; the next one can only gain.</p>";
  std::vector<std::string> items;
  for (const std::string& one : verdict.good) items.push_back(htmlText(one));
  return htmlList(items);
}

std::string changes(const Debrief& debrief, const Verdict& verdict) {
  if (verdict.deductions.empty()) return "<p>Nothing: all was as wanted.</p>";
  std::string html;
  std::string clip = debrief.clip;
  for (std::size_t i = 0; i < verdict.deductions.size(); ++i) {
    const Deduction& d = verdict.deductions[i];
    const std::string png = i < debrief.pictures.size() ? debrief.pictures[i] : "";
    const std::string film = d.time ? htmlClip(std::exchange(clip, ""), d.fact) : "";
    html += filled("change.html", {{"number", fmt::format("{}", i + 1)},
                                   {"time", d.time ? timeText(*d.time) : ""},
                                   {"fact", htmlText(d.fact)},
                                   {"picture", htmlPicture(png, d.fact) + film},
                                   {"question", htmlText(d.question)},
                                   {"next", htmlText(d.next)}});
  }
  return html;
}

std::string method(const Scored& scored) {
  const Attempt& attempt = scored.attempt;
  std::vector<std::string> lines{
      htmlText(fmt::format("Recording {}, made by {}{}.",
                           std::filesystem::path(attempt.file).filename().string(), attempt.program,
                           attempt.complete ? "" : "; it was cut short")),
      htmlText(
          fmt::format("Movements: faster than 50 mm/s for more than 0.2 s (PerkTutor). Idle: "
                      "slower than 5 mm/s (a setting). Smoothness, per movement: Balasubramanian "
                      "et al. 2015.")),
      "Grades of bleeding: VIBe (Lewis et al. 2017); surgeons differ by one grade.",
      "Vessels are counted one by one from 2 mm on (a setting)."};
  if (const auto limit = forceLimitOf(*attempt.task))
    lines.push_back(htmlText(fmt::format("Force limit {:g} N: {}.", limit->force, limit->source)));
  if (attempt.undos > 0)
    lines.push_back(htmlText(
        fmt::format("Work was taken back {} times; this counts as an attempt.", attempt.undos)));
  return htmlList(lines);
}

}  // namespace

std::string htmlPicture(const std::string& png, std::string_view about) {
  if (png.empty()) return "";
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", htmlText(about),
                     base64(png));
}

std::string debriefPage(const Debrief& debrief) {
  const Scored& last = debrief.attempts.back();
  const Task& task = *last.attempt.task;
  const std::string& learner = last.attempt.learner;
  const std::string body =
      filled("debrief.html", {{"outcome", !last.verdict.graded  ? ""
                                          : last.verdict.passed ? "passed"
                                                                : "failed"},
                              {"scenario", htmlText(last.attempt.scenario)},
                              {"level", std::string(wordOf(last.level))},
                              {"learner", learner.empty() ? "" : htmlText(", " + learner)},
                              {"title", htmlText(last.attempt.title)},
                              {"verdict", htmlText(verdictWord(last.verdict))},
                              {"reason", htmlText(last.verdict.reason)},
                              {"goal", htmlText(goalSentence(task))},
                              {"teaches", htmlText(task.teaches)},
                              {"good", goodThings(last.verdict)},
                              {"changes", changes(debrief, last.verdict)},
                              {"timeline", timelines(last)},
                              {"paths", pathViews(last)},
                              {"margin", marginSection(last.attempt)},
                              {"figures", figureTable(debrief)},
                              {"studies", studyTable(debrief.studies, last.measures)},
                              {"vessels", vesselSection(last.attempt)},
                              {"ledger", ledgerTable(last.attempt)},
                              {"history", historySection(debrief)},
                              {"method", method(last)}});
  return htmlPage(last.attempt.title, body,
                  "This page needs no network. Resect trains and measures; it does not certify.");
}

}  // namespace resect

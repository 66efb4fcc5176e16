#include "skills/report/task_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/whole_file.h"
#include "operation/task/measure.h"
#include "skills/report/debrief.h"
#include "skills/report/debrief_tables.h"
#include "skills/report/html.h"
#include "skills/score/bands.h"
#include "skills/score/findings.h"

namespace resect {
namespace {

std::string pictureBeside(const Scenario& scenario) {
  std::filesystem::path file = scenario.file;
  file.replace_extension(".png");
  std::error_code none;
  if (scenario.file.empty() || !std::filesystem::exists(file, none)) return "";
  return htmlFigure(htmlPicture(readWholeFile(file), scenario.title), "");
}

std::string stepsOf(const Task& task) {
  std::string html;
  for (const std::string& step : task.steps) html += "<li>" + htmlText(step) + "</li>\n";
  return html.empty() ? "" : "<ol>\n" + html + "</ol>\n";
}

// "at most 30 ml", "any".
std::string wanted(const std::string& measure, const std::vector<TaskLimit>& limits) {
  const auto at = std::ranges::find(limits, measure, &TaskLimit::measure);
  if (at == limits.end()) return "any";
  return limitText(Check{measure, {}, at->least, at->most, true, true, ""});
}

std::string limitTable(const Task& task) {
  HtmlTable table;
  table.head = {{"measure"}};
  for (const TaskLevel level : kTaskLevels) table.head.push_back({std::string(wordOf(level))});
  for (const MeasureKind& kind : measureKinds()) {
    const std::string measure(kind.id);
    std::vector<HtmlCell> row{{htmlText(kind.title)}};
    bool any = false;
    for (const TaskLevel level : kTaskLevels) {
      row.push_back({htmlText(wanted(measure, limitsAt(task, level)))});
      any = any || row.back().html != "any";
    }
    if (any) table.rows.push_back(std::move(row));
  }
  return table.rows.empty() ? "<p>The goal; there are no limits.</p>\n" : toHtml(table);
}

std::string rulesOf(const Task& task) {
  std::vector<std::string> rules;
  for (const TaskBand& band : task.bands)
    rules.push_back(htmlText(fmt::format(
        "{}: no worse than {:g} standard deviations from the mean of {} reference runs, {}.",
        findMeasure(band.measure)->title, task.bandWidth, task.bandRuns,
        measureText(band.measure, band.mean))));
  if (std::ranges::count(task.pass, "all") == 0) {
    std::string names;
    for (const std::string& one : task.pass) {
      const MeasureKind* kind = findMeasure(one);
      names += (names.empty() ? "" : ", ") + (kind ? std::string(kind->title) : one);
    }
    rules.push_back(htmlText(fmt::format("Of these a pass takes: {}.", names)));
  }
  rules.push_back(task.guidance ? "Guidance is shown at the levels easy and medium."
                                : "There is no guidance.");
  if (task.familiarisation) rules.push_back("The first attempt is for practice and not graded.");
  rules.push_back(task.undo ? "Work may be taken back; each time is counted."
                            : "No work is taken back.");
  return htmlList(rules);
}

std::string studiesOf(const Task& task) {
  std::vector<PublishedStudy> studies;
  for (const std::string& name : task.published) studies.push_back(readPublishedStudy(name));
  return studies.empty() ? "" : htmlSection("What studies have measured", studyTable(studies, {}));
}

}  // namespace

std::string taskPage(const Scenario& scenario) {
  const Task& task = *scenario.task;
  const std::string background =
      task.background.empty() ? ""
                              : htmlSection("Why", "<p>" + htmlText(task.background) + "</p>\n");
  const std::string body = filled("task.html", {{"scenario", htmlText(scenario.name)},
                                                {"title", htmlText(scenario.title)},
                                                {"teaches", htmlText(task.teaches)},
                                                {"picture", pictureBeside(scenario)},
                                                {"goal", htmlText(goalSentence(task))},
                                                {"steps", stepsOf(task)},
                                                {"background", background},
                                                {"limits", limitTable(task)},
                                                {"rules", rulesOf(task)},
                                                {"studies", studiesOf(task)}});
  return htmlPage(scenario.title, body,
                  "This page needs no network. Resect trains and measures; it does not certify.");
}

}  // namespace resect

#include "skills/class/class_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "operation/task/measure.h"
#include "skills/report/chart.h"
#include "skills/report/html.h"
#include "skills/report/report_json.h"
#include "skills/score/findings.h"

namespace resect {
namespace {

HtmlCell text(std::string_view plain) { return {htmlText(plain)}; }
HtmlCell number(const std::string& plain) { return {htmlText(plain), "number"}; }

std::string bestScore(const LearnerCourse& course) {
  const ClassAttempt* best = nullptr;
  for (const ClassAttempt& one : course.attempts)
    if (one.graded && (!best || one.score > best->score)) best = &one;
  return best ? fmt::format("{:.0f} %, {}", 100 * best->score, wordOf(best->level)) : "";
}

// "passed at attempt 3, easy", of all attempts, the ungraded ones included.
HtmlCell resultCell(const LearnerCourse& course) {
  for (std::size_t i = 0; i < course.attempts.size(); ++i)
    if (course.attempts[i].graded && course.attempts[i].passed)
      return {fmt::format("passed at attempt {}, {}", i + 1, wordOf(course.attempts[i].level)),
              "kept"};
  return {"not yet", "missed"};
}

std::string competentText(const LearnerCourse& course, const LearningTest& test) {
  const auto at = competentAt(learningCusum(passes(course), test), test);
  return at ? fmt::format("after {} graded attempts", *at + 1) : "not shown yet";
}

std::string learnerTable(const TaskCourse& task, const LearningTest& test) {
  HtmlTable table;
  table.head = {text("learner"),
                number("attempts"),
                text("result"),
                number("best"),
                text("competence (LC-CUSUM)"),
                text("last attempt")};
  for (const LearnerCourse& course : task.learners)
    table.rows.push_back({text(course.learner), number(fmt::format("{}", course.attempts.size())),
                          resultCell(course), number(bestScore(course)),
                          text(competentText(course, test)), text(course.attempts.back().reason)});
  return toHtml(table);
}

std::vector<Eigen::Vector2d> counted(const std::vector<double>& values) {
  std::vector<Eigen::Vector2d> points{{0, 0}};
  for (std::size_t i = 0; i < values.size(); ++i) points.emplace_back(double(i + 1), values[i]);
  return points;
}

std::size_t mostAttempts(const TaskCourse& task) {
  std::size_t most = 1;
  for (const LearnerCourse& course : task.learners) most = std::max(most, course.attempts.size());
  return most;
}

std::string curves(const TaskCourse& task, const LearningTest& test) {
  if (std::ranges::none_of(task.learners,
                           [](const LearnerCourse& course) { return passes(course).size() > 1; }))
    return "<p class=\"quiet\">Learning curves begin with a second graded attempt.</p>\n";
  const double most = double(mostAttempts(task));
  TimeChart lc{"LC-CUSUM", "", most, {}, {}, test.signal, ""};
  TimeChart sum{"CUSUM of failures", "", most, {}, {}, {}, ""};
  for (std::size_t l = 0; l < task.learners.size(); ++l) {
    const LearnerCourse& course = task.learners[l];
    const std::vector<bool> passed = passes(course);
    std::vector<double> failures;
    for (const bool one : passed) failures.push_back(one ? 0 : 1);
    lc.curves.push_back({course.learner, chartColour(l), counted(learningCusum(passed, test))});
    sum.curves.push_back(
        {course.learner, chartColour(l), counted(cusum(failures, test.inadequate))});
  }
  return htmlFigure(toSvg(lc), "By graded attempt. Above the dashed line competence is shown.") +
         htmlFigure(toSvg(sum),
                    "By graded attempt. The curve turns down where a learner passes more often.");
}

std::string difficultyTable(const TaskCourse& task) {
  HtmlTable table;
  table.head = {text("what is wanted"), number("kept by"), number("graded attempts")};
  for (const CheckDifficulty& d : difficulties(task)) {
    if (d.attempts == 0) continue;
    const MeasureKind* kind = findMeasure(d.measure);
    table.rows.push_back({text(kind ? kind->title : "the goal"),
                          number(fmt::format("{:.0f} %", 100.0 * d.kept / d.attempts)),
                          number(fmt::format("{}", d.attempts))});
  }
  return toHtml(table);
}

std::string settingsText(const LearningTest& test) {
  return fmt::format(
      "LC-CUSUM: inadequate failure rate {:g}, adequate {:g}, signal at {:g} "
      "(settings). A first attempt is for practice and does not count, where the task "
      "says so.",
      test.inadequate, test.adequate, test.signal);
}

}  // namespace

std::string classPage(const ClassBook& book, const LearningTest& test) {
  std::string body = fmt::format("<header><p class=\"kicker\">Class</p><h1>{}</h1></header>\n",
                                 htmlText(book.name));
  for (const TaskCourse& task : book.tasks)
    body += htmlSection(task.title,
                        learnerTable(task, test) + curves(task, test) + difficultyTable(task));
  if (!book.refused.empty()) {
    std::vector<std::string> items;
    for (const std::string& sentence : book.refused) items.push_back(htmlText(sentence));
    body += htmlSection("Recordings that could not be scored", htmlList(items));
  }
  return htmlPage(book.name, body, settingsText(test));
}

void writeClassRows(CsvWriter& csv, const ClassBook& book, const LearningTest& test) {
  csv.cell("task").cell("learner").cell("attempt").cell("file").cell("level").cell("graded").cell(
      "passed");
  csv.cell("goal_reached").cell("score").cell("lc_cusum");
  for (const MeasureKind& kind : measureKinds()) csv.cell(kind.id);
  csv.end();
  const auto flag = [](bool yes) { return std::string_view(yes ? "yes" : "no"); };
  for (const TaskCourse& task : book.tasks)
    for (const LearnerCourse& course : task.learners) {
      const std::vector<double> curve = learningCusum(passes(course), test);
      std::size_t graded = 0;
      for (std::size_t i = 0; i < course.attempts.size(); ++i) {
        const ClassAttempt& one = course.attempts[i];
        csv.cell(task.scenario).cell(course.learner).cell(i + 1).cell(one.file);
        csv.cell(wordOf(one.level))
            .cell(flag(one.graded))
            .cell(flag(one.passed))
            .cell(flag(one.goalReached));
        csv.cell(printed(one.score));
        if (one.graded)
          csv.cell(printed(curve[graded++]));
        else
          csv.empty();
        for (const MeasureKind& kind : measureKinds()) {
          if (const auto value = valueOf(one.measures, kind.id))
            csv.cell(printed(*value));
          else
            csv.empty();
        }
        csv.end();
      }
    }
}

}  // namespace resect

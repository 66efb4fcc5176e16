// Goals, verdicts and findings of attempts that are written down by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "skills/class/class_book.h"
#include "skills/score/findings.h"
#include "skills/score/verdict.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

// Ten seconds with one instrument that goes 0.1 m along x, in hand all the time, at work from 2 s
// to 8 s with a force of 1 N, and 4 N at 5 s.
Attempt attemptAt(TaskGoal::Kind kind) {
  Attempt attempt;
  attempt.file = "a.resect";
  attempt.interval = 0.1;
  attempt.tissueMoves = true;
  attempt.task.emplace();
  attempt.task->goal.kind = kind;
  InstrumentRecord tool{"Hook", "hook", Vec3::UnitZ(), {}};
  for (int f = 1; f <= 100; ++f) {
    attempt.time.push_back(0.1 * f);
    ToolMoment now;
    now.inHand = true;
    now.tip = {0.001 * f, 0, 0};
    now.works = f >= 20 && f < 80;
    now.force = f == 50 ? 4 : now.works ? 1 : 0;
    tool.moments.push_back(now);
  }
  attempt.instruments.push_back(tool);
  return attempt;
}

Attempt touching(std::initializer_list<std::pair<int, int>> held) {
  Attempt attempt = attemptAt(TaskGoal::Kind::Touch);
  for (const auto& [from, to] : held) {
    std::vector<float> distance(100, std::numeric_limits<float>::infinity());
    std::fill(distance.begin() + from, distance.begin() + to, 0.004f);
    attempt.goal.distance.push_back(distance);
  }
  return attempt;
}

Attempt bleeding(double until) {
  Attempt attempt = attemptAt(TaskGoal::Kind::StopBleeding);
  attempt.bleeds = true;
  for (const double t : attempt.time)
    attempt.bled.push_back(1e-6 * std::clamp(t - 2, 0.0, until - 2));  // 1 ml/s from 2 s on
  return attempt;
}

VesselStory vesselCut(double time, bool root, bool far) {
  VesselStory v;
  v.diameter = 0.0031;
  v.cut = time;
  v.severed = true;
  v.clippedRoot = root, v.clippedFar = far;
  v.bled = 38e-6;
  return v;
}

const Deduction* about(const Verdict& verdict, const std::string& measure) {
  const auto at = std::ranges::find(verdict.deductions, measure, &Deduction::measure);
  return at == verdict.deductions.end() ? nullptr : &*at;
}

}  // namespace

TEST_CASE("targets are held in turn and for long enough") {
  const GoalResult both = goalResult(touching({{10, 25}, {30, 41}}));
  CHECK(both.reached);
  CHECK(*both.time == doctest::Approx(4.0));
  CHECK(*valueOf(both.measures, "drift_mm") == doctest::Approx(4));
  CHECK(!goalResult(touching({{30, 45}, {10, 25}})).reached);  // in the other order
  const GoalResult brief = goalResult(touching({{10, 25}, {30, 39}}));
  CHECK(!brief.reached);
  CHECK(*valueOf(brief.measures, "targets_held") == 1);
}

TEST_CASE("a line is followed where work was near it, between frames too") {
  Attempt attempt = attemptAt(TaskGoal::Kind::Follow);
  attempt.goal.lineLength = 0.06;
  for (std::size_t f = 20; f < 80; f += 2)
    attempt.goal.work.push_back({f, 0.001 * double(f - 20), f == 50 ? 0.02 : 0.002});
  const GoalResult whole = goalResult(attempt);
  CHECK(whole.reached);
  CHECK(*valueOf(whole.measures, "off_line_most_mm") == doctest::Approx(20));
  CHECK(*whole.time == doctest::Approx(5.1));
  attempt.goal.work.resize(15);
  const GoalResult half = goalResult(attempt);
  CHECK(!half.reached);
  CHECK(*valueOf(half.measures, "line_covered_pct") == doctest::Approx(48).epsilon(0.05));
  attempt.task->goal.holdWith = "hook";
  attempt.goal.held.assign(100, 0);
  std::fill(attempt.goal.held.begin(), attempt.goal.held.begin() + 34, 1);
  CHECK(*valueOf(goalResult(attempt).measures, "held_pct") == doctest::Approx(100.0 * 7 / 15));
}

TEST_CASE("a structure is resected whole and with its margin") {
  Attempt attempt = attemptAt(TaskGoal::Kind::Resect);
  attempt.task->goal.structure = "tumour";
  attempt.targetBefore = 4e-6;
  attempt.specimens = {{0, 60e-6, 0.06, 0}, {0, 30e-6, 0.03, 4e-6}};
  attempt.margin = 0.0105;
  CHECK(goalResult(attempt).reached);
  attempt.margin = 0.0095;
  CHECK(!goalResult(attempt).reached);
  attempt.margin = 0.0105;
  attempt.specimens[1].target = 3e-6;
  const GoalResult left = goalResult(attempt);
  CHECK(!left.reached);
  CHECK(*valueOf(left.measures, "target_left_ml") == doctest::Approx(1));
}

TEST_CASE("bleeding counts as stopped when it stays below the rate") {
  const GoalResult stopped = goalResult(bleeding(6));
  CHECK(stopped.reached);
  CHECK(*valueOf(stopped.measures, "bleeding_s") == doctest::Approx(4.8).epsilon(0.05));
  CHECK(!goalResult(bleeding(20)).reached);
  CHECK(!goalResult(bleeding(8.9)).reached);  // not quiet for long enough
  Attempt dry = bleeding(6);
  std::ranges::fill(dry.bled, 0.0);
  CHECK(!goalResult(dry).reached);  // nothing was stopped
}

TEST_CASE("a vessel is divided between two clips that were there before") {
  Attempt attempt = attemptAt(TaskGoal::Kind::Divide);
  CHECK(!goalResult(attempt).reached);
  attempt.vessels = {vesselCut(3, true, true)};
  CHECK(goalResult(attempt).reached);
  attempt.vessels = {vesselCut(3, true, false)};
  CHECK(goalResult(attempt).sentence.find("far side") != std::string::npos);
  attempt.vessels[0].place = {0.03, 0, 0};  // another vessel
  CHECK(goalResult(attempt).sentence.find("not divided") != std::string::npos);
}

TEST_CASE("an attempt passes by its goal, its limits and its rules") {
  Attempt attempt = touching({{10, 25}});
  attempt.task->limits = {{"force_peak_n", {}, 5}, {"path_length_m", {}, 0.2}};
  attempt.task->levels[std::size_t(TaskLevel::Hard)] = {{"force_peak_n", {}, 3}};
  const Scored medium = score(attempt);
  CHECK(medium.verdict.passed);
  CHECK(medium.verdict.score == 1);
  CHECK(medium.verdict.deductions.empty());
  CHECK(medium.verdict.good.size() == 3);
  const Scored hard = score(attempt, TaskLevel::Hard);
  CHECK(!hard.verdict.passed);
  CHECK(hard.verdict.score == doctest::Approx(2.0 / 3));
  const Deduction* force = about(hard.verdict, "force_peak_n");
  REQUIRE(force);
  CHECK(*force->time == doctest::Approx(5.0));
  CHECK(force->fact.find("4.0 N on the Hook") != std::string::npos);

  attempt.task->pass = {"goal", "path_length_m"};  // the teacher's rule
  CHECK(score(attempt, TaskLevel::Hard).verdict.passed);
  attempt.task->instruments = {"scalpel"};
  const Scored other = score(attempt, TaskLevel::Hard);
  CHECK(!other.verdict.passed);
  CHECK(other.verdict.reason.find("Hook") != std::string::npos);
  attempt.task->instruments = {"hook"};
  attempt.undos = 2;
  CHECK(score(attempt, TaskLevel::Hard).verdict.passed);  // counts, and is marked
  attempt.task->undo = false;
  CHECK(!score(attempt, TaskLevel::Hard).verdict.passed);
}

TEST_CASE("a band lets pass what is no worse than so many deviations") {
  Attempt attempt = touching({{10, 25}});
  attempt.task->bandRuns = 4;
  attempt.task->bands = {{"path_length_m", 0.05, 0.025}};  // 0.099 is within two deviations
  CHECK(score(attempt).verdict.passed);
  attempt.task->bandWidth = 1;
  CHECK(!score(attempt).verdict.passed);
  attempt.task->bands = {{"path_length_m", 0.5, 0.025}};  // much better than the mean
  CHECK(score(attempt).verdict.passed);
}

TEST_CASE("a vessel that was cut unclipped is told with its size, time and blood") {
  Attempt attempt = bleeding(6);
  attempt.vessels = {vesselCut(4.2, false, false)};
  attempt.vessels[0].closed = 7;
  attempt.task->limits = {{"vessels_unsealed", {}, 0}};
  const Scored scored = score(attempt);
  const Deduction* told = about(scored.verdict, "vessels_unsealed");
  REQUIRE(told);
  CHECK(told->fact == "Portal vein of 3.1 mm cut unclipped, 38 ml lost, closed 2.8 s later.");
  CHECK(*told->time == 4.2);
  CHECK(told->question.ends_with("?"));
  CHECK(*valueOf(scored.measures, "seal_time_s") == doctest::Approx(2.8));
}

TEST_CASE("times and numbers as people read them") {
  CHECK(timeText(65.27) == "1:05.3");
  CHECK(timeText(59.96) == "1:00.0");
  CHECK(numberText(1234.4) == "1234");
  CHECK(numberText(0.012345) == "0.0123");
  CHECK(measureText("force_peak_n", 2.5) == "2.5 N");
}

TEST_CASE("the files of a class, in the order of their numbers, and whose they are") {
  const test::TemporaryFolder folder;
  for (const char* name : {"anna/10.resect", "anna/2.resect", "bela-1.resect", "bela-12.resect",
                           "bela-3.resect", "notes.txt"}) {
    const auto path = folder.path() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << "x";
  }
  std::vector<ClassFile> files = classFiles(folder.path());
  REQUIRE(files.size() == 5);
  CHECK(files[0].path.filename() == "2.resect");
  CHECK(files[1].path.filename() == "10.resect");
  CHECK(files[4].path.filename() == "bela-12.resect");
  CHECK((files[0].learner == "anna" && files[4].learner == "bela"));
  usePseudonyms(files);
  CHECK((files[0].learner == "learner 1" && files[4].learner == "learner 2"));
}

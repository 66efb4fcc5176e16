// Goals, verdicts and findings of attempts that are written down by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "skills/class/class_book.h"
#include "skills/score/bands.h"
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
    now.inHand = now.taken = true;
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
  v.name = "portal vein";
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

TEST_CASE("evidence of a missed target is of that target, and not of the one before") {
  const GoalResult brief = goalResult(touching({{10, 25}, {30, 39}}));
  CHECK(*brief.time == doctest::Approx(3.1));
  CHECK(brief.sentence.find("Target 2 was held for 0.9 s at most") != std::string::npos);

  Attempt beside = touching({{10, 25}, {0, 0}, {0, 0}});
  std::fill(beside.goal.distance[1].begin() + 40, beside.goal.distance[1].end(), 0.05f);
  beside.goal.distance[1][60] = 0.012f;
  const GoalResult near = goalResult(beside);
  CHECK(*near.time == doctest::Approx(6.1));
  CHECK(near.sentence.find("no nearer than 12 mm to target 2") != std::string::npos);

  // The tip rests on the first target for longer than it need, nearer to the second than ever
  // after.
  Attempt rests = touching({{10, 40}, {0, 0}});
  std::fill(rests.goal.distance[1].begin() + 10, rests.goal.distance[1].begin() + 40, 0.05f);
  std::fill(rests.goal.distance[1].begin() + 60, rests.goal.distance[1].begin() + 70, 0.07f);
  CHECK(*goalResult(rests).time == doctest::Approx(6.1));

  const GoalResult never = goalResult(touching({{10, 25}, {0, 0}}));  // held at 2 s
  CHECK(*never.time > 3);
  CHECK(never.sentence.find("Target 2 was not touched") != std::string::npos);
}

TEST_CASE("the score grows with what was done of the goal, and a pass is above it") {
  const auto scoreOf = [](std::initializer_list<std::pair<int, int>> held) {
    Attempt attempt = touching(held);
    attempt.task->limits = {{"force_peak_n", {}, 5}, {"path_length_m", {}, 0.2}};
    return score(attempt).verdict.score;
  };
  CHECK(scoreOf({{0, 0}, {0, 0}, {0, 0}, {0, 0}}) == 0);
  CHECK(scoreOf({{0, 12}, {20, 32}, {0, 0}, {0, 0}}) == doctest::Approx(0.25));
  CHECK(scoreOf({{0, 12}, {20, 32}, {40, 52}, {0, 0}}) == doctest::Approx(0.375));
  CHECK(scoreOf({{0, 12}, {20, 32}, {40, 52}, {60, 72}}) == 1);

  Attempt reckless = touching({{10, 25}});  // reached, and no limit was kept
  reckless.task->limits = {{"force_peak_n", {}, 1}, {"path_length_m", {}, 0.01}};
  CHECK(score(reckless).verdict.score == doctest::Approx(0.5));

  // A vessel: a clip, another one, the cut.
  Attempt divided = attemptAt(TaskGoal::Kind::Divide);
  divided.goal.restPlaces = {Vec3::Zero()};
  CHECK(goalResult(divided).done == 0);
  divided.clips = {{1, 0, 0, {0.005, 0, 0}, {}}, {1, 0, 0, {0.5, 0, 0}, {}}};
  CHECK(goalResult(divided).done == doctest::Approx(1.0 / 3));
  divided.vessels = {vesselCut(3, false, false)};
  CHECK(goalResult(divided).done == 0);
  divided.vessels = {vesselCut(3, true, true)};
  CHECK(goalResult(divided).done == 1);

  Attempt parted = attemptAt(TaskGoal::Kind::Transect);
  parted.task->goal.radius = 0.01;
  parted.goal.work = {{30, 0, 0.001}, {50, 0, 0.02}};
  CHECK(goalResult(parted).done == 0);
  CHECK(*goalResult(parted).time == doctest::Approx(5.1));
  parted.specimens = {{0, 60e-6, 0.06, 0}};
  CHECK(goalResult(parted).done == doctest::Approx(0.75));
}

TEST_CASE("a time that ran out is the reason, and no fault besides") {
  Attempt attempt = touching({{0, 12}, {0, 0}});
  attempt.task->limits = {{"total_time_s", {}, 9.98}};
  const Verdict late = score(attempt).verdict;
  CHECK(about(late, "total_time_s") == nullptr);
  CHECK(late.deductions.size() == 1);
  CHECK(late.reason.find("The time of 9.98 s was up.") != std::string::npos);
  CHECK(late.reason.find("Besides") == std::string::npos);

  Attempt done = touching({{0, 12}});  // the goal was reached: then it is a fault
  done.task->limits = {{"total_time_s", {}, 9.999}};
  const Verdict slow = score(done).verdict;
  REQUIRE(about(slow, "total_time_s"));
  CHECK(slow.reason.find("was up") == std::string::npos);
  CHECK(about(slow, "total_time_s")->next.find("timeline") != std::string::npos);
  const Check near{"total_time_s", 45.0167, {}, 45, false, true, ""};
  CHECK(valueText(near) == "45.0167");  // and not "45 s, wanted at most 45 s"
  const Check far{"total_time_s", 60.0167, {}, 45, false, true, ""};
  CHECK(valueText(far) == "60");
}

TEST_CASE("what was not reached is not praised, nor little of what was not done") {
  Attempt attempt = bleeding(20);  // it never stops
  attempt.task->limits = {{"bleeding_s", {}, 18},   {"blood_loss_ml", {}, 20},
                          {"total_time_s", {}, 45}, {"path_length_m", {}, 1},
                          {"force_peak_n", {}, 5},  {"seal_time_s", {}, 20}};
  attempt.vessels = {vesselCut(4.2, false, false)};  // nor is it closed
  const Scored scored = score(attempt);
  CHECK(!valueOf(scored.measures, "bleeding_s"));
  CHECK(!valueOf(scored.measures, "seal_time_s"));
  REQUIRE(scored.verdict.good.size() == 1);
  CHECK(scored.verdict.good[0].find("Largest force") == 0);
  REQUIRE(about(scored.verdict, "seal_time_s"));
  CHECK(about(scored.verdict, "seal_time_s")->fact.find("closed: never, wanted") !=
        std::string::npos);

  Attempt idle = attemptAt(TaskGoal::Kind::Follow);
  for (ToolMoment& m : idle.instruments[0].moments) m.works = false, m.force = 0;
  idle.task->limits = {{"force_peak_n", {}, 5}, {"off_line_mm", {}, 3}};
  CHECK(score(idle).verdict.good.empty());
}

TEST_CASE("a force counts as an error above the limit of the level, if there is one") {
  Attempt attempt = touching({{10, 25}});  // 1 N, and once 4 N
  CHECK(!valueOf(score(attempt).measures, "force_errors"));
  attempt.task->forceLimit = 0.5;
  CHECK(*valueOf(score(attempt).measures, "force_errors") == 1);
  CHECK(forceLimitOf(*attempt.task)->force == 0.5);
  attempt.task->limits = {{"force_peak_n", {}, 0.5}};
  attempt.task->levels[std::size_t(TaskLevel::Easy)] = {{"force_peak_n", {}, 5}};
  const Scored easy = score(attempt, TaskLevel::Easy);
  CHECK(*valueOf(easy.measures, "force_errors") == 0);
  CHECK(forceLimitOf(*easy.attempt.task)->force == 5);
  CHECK(forceLimitOf(*easy.attempt.task)->source == "limit of the task, easy");
}

TEST_CASE("the way of an instrument is that of the hand, also while it only hovers") {
  Attempt attempt = touching({{10, 25}});
  for (std::size_t f = 30; f < 100; ++f) attempt.instruments[0].moments[f].inHand = false;
  const auto all = measuresOf(attempt);
  CHECK(*valueOf(all, "path_length_m") == doctest::Approx(0.099));
  for (std::size_t f = 50; f < 100; ++f) attempt.instruments[0].moments[f].taken = false;
  CHECK(*valueOf(measuresOf(attempt), "path_length_m") == doctest::Approx(0.049));
}

TEST_CASE("a line is followed where work was near it, between frames too") {
  Attempt attempt = attemptAt(TaskGoal::Kind::Follow);
  attempt.goal.lineLength = 0.06;
  for (std::size_t f = 20; f < 80; f += 2)
    attempt.goal.work.push_back({f, 0.001 * double(f - 20), f == 50 ? 0.02 : 0.002});
  const GoalResult whole = goalResult(attempt);
  CHECK(*valueOf(whole.measures, "off_line_most_mm") == doctest::Approx(20));
  CHECK(*whole.time == doctest::Approx(5.1));
  CHECK(!whole.reached);  // it went farther from the line than the goal says
  CHECK(whole.done == doctest::Approx(0.006 / 0.02));
  CHECK(whole.sentence.find("went 20 mm from the line; 6 mm is allowed") != std::string::npos);
  CHECK(goalSentence(*attempt.task).find("no farther than 6 mm from it") != std::string::npos);
  attempt.task->limits = {{"off_line_most_mm", {}, 15}};  // a check of its own
  CHECK(goalResult(attempt).reached);
  CHECK(goalSentence(*attempt.task).find("nowhere farther than 15 mm") != std::string::npos);
  CHECK(!score(attempt).verdict.passed);
  attempt.task->limits[0].most = 25;
  CHECK(score(attempt).verdict.passed);
  attempt.goal.work.resize(15);
  const GoalResult half = goalResult(attempt);
  CHECK(!half.reached);
  CHECK(*valueOf(half.measures, "line_covered_pct") == doctest::Approx(48).epsilon(0.05));
  CHECK(half.sentence.find("Not followed: 29 to 60 mm") != std::string::npos);
  REQUIRE(half.unfollowed.size() == 1);
  CHECK(half.unfollowed[0].first == doctest::Approx(0.029));
  CHECK(half.unfollowed[0].second == doctest::Approx(0.06));
  CHECK(half.done == doctest::Approx(0.48 / 0.9).epsilon(0.05));
  CHECK(*half.time == doctest::Approx(4.9));  // where the work was nearest to what is missing
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
  CHECK(goalResult(bleeding(20)).done < 0.2);
  CHECK(!valueOf(goalResult(bleeding(20)).measures, "bleeding_s"));

  Attempt shallow = bleeding(6);  // 60 ml/min
  shallow.task->goal.from = 100e-6 / 60;
  const GoalResult little = goalResult(shallow);
  CHECK(!little.reached);
  CHECK(little.done == 0);
  CHECK(little.sentence ==
        "It bled at 60 ml/min at most; a bleeding of 100 ml/min or more was to be "
        "stopped.");
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
  CHECK(hard.verdict.score == doctest::Approx(0.75));  // the goal, and one of two limits
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

TEST_CASE("bands of a teacher's runs: mean and deviation of what all of them have") {
  const auto run = [](double time, double path, double moves) {
    return std::vector<Measured>{{"time_s", "", time},
                                 {"path_length_m", "", path},
                                 {"path_length_m", "scalpel", 99},
                                 {"movements", "", moves},
                                 {"sparc", "", -path}};
  };
  std::vector<std::vector<Measured>> runs{run(10, 0.5, 4), run(12, 0.7, 4)};
  CHECK(bandsOf(runs).empty());  // two are too few
  runs.push_back(run(14, 0.6, 4));
  runs[0].push_back({"blood_loss_ml", "", 3});  // the others lack it
  const std::vector<TaskBand> bands = bandsOf(runs);
  REQUIRE(bands.size() == 2);  // movements are the same in all
  CHECK(bands[0].measure == "time_s");
  CHECK(bands[0].mean == doctest::Approx(12));
  CHECK(bands[0].deviation == doctest::Approx(2));
  CHECK(bands[1].measure == "path_length_m");
  CHECK(bands[1].mean == doctest::Approx(0.6));
  CHECK(bands[1].deviation == doctest::Approx(0.1));
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

TEST_CASE("a wound from the start is no cut of the learner's, and is open until it is closed") {
  Attempt attempt = bleeding(20);
  attempt.vessels = {vesselCut(0, false, false)};
  attempt.vessels[0].before = true;
  attempt.tissue = {{0, 1, 0, 0, 3e-4}, {10, 1, 0, 0, 4e-4}};
  const auto value = [&](const char* measure) { return valueOf(score(attempt).measures, measure); };
  CHECK(*value("vessels_cut") == 0);
  CHECK(*value("vessels_unsealed") == 0);
  CHECK(*value("vessels_open") == 1);
  CHECK(*value("cut_cm2") == doctest::Approx(1));
  attempt.vessels[0].closed = 7;
  CHECK(*value("vessels_open") == 0);
  CHECK(*value("seal_time_s") == doctest::Approx(7));
  attempt.vessels[0].closed.reset();
  attempt.vessels[0].bled = 0.5e-7;  // a nick in a vein
  CHECK(*value("vessels_open") == 0);
  CHECK(!value("seal_time_s"));       // nothing was closed
  attempt.vessels[0].before = false;  // but what the learner cuts is to be closed
  CHECK(*value("vessels_open") == 1);
  attempt.vessels = {vesselCut(3, true, true)};
  attempt.vessels[0].closed = 3;  // by the clips that were there before
  CHECK(*value("seal_time_s") == 0);
}

TEST_CASE("evidence of lost time is the longest wait, and advice follows what was done") {
  Attempt attempt = bleeding(20);  // 60 ml/min from 2 s on
  attempt.task->limits = {{"blood_loss_ml", {}, 1}};
  attempt.task->steps = {"Press on it.", "Clip it.", "Seal the rest."};
  for (ToolMoment& m : attempt.instruments[0].moments) m.works = false;
  const Scored idle = score(attempt);
  CHECK(idle.verdict.deductions[0].next == "Press on it.");
  const Deduction* blood = about(idle.verdict, "blood_loss_ml");
  REQUIRE(blood);
  CHECK(blood->fact.find(
            "For 10 s from 0:00.1 on no instrument touched the organ, while it bled at") !=
        std::string::npos);
  for (std::size_t f = 20; f < 30; ++f) attempt.instruments[0].moments[f].works = true;
  const Scored one = score(attempt);
  CHECK(one.verdict.deductions[0].next == "Clip it.");
  CHECK(about(one.verdict, "blood_loss_ml")->fact.find("For 7 s from 0:03.1 on") !=
        std::string::npos);

  Attempt slow = touching({{10, 25}});
  slow.task->limits = {{"time_s", {}, 5}};
  for (std::size_t f = 30; f < 60; ++f) slow.instruments[0].moments[f].works = false;
  const Scored late = score(slow);
  const Deduction* time = about(late.verdict, "time_s");
  REQUIRE(time);
  CHECK(*time->time == doctest::Approx(3.1));
  CHECK(time->fact.find("For 3 s from 0:03.1 on no instrument touched the organ.") !=
        std::string::npos);
}

TEST_CASE("of the blood the largest source is told, and called most of it only if it is") {
  Attempt attempt = bleeding(9);  // 7 ml
  attempt.task->limits = {{"blood_loss_ml", {}, 5}};
  attempt.vessels = {vesselCut(4.2, false, false), vesselCut(4.5, false, false)};
  attempt.vessels[0].bled = 2e-6, attempt.vessels[1].bled = 1e-6;
  CHECK(about(score(attempt).verdict, "blood_loss_ml")
            ->fact.find(
                "The largest share of one vessel, 2.0 ml, came from the portal vein of 3.1 mm") !=
        std::string::npos);
  attempt.vessels[0].bled = 4e-6;
  CHECK(about(score(attempt).verdict, "blood_loss_ml")->fact.find("Most of the blood, 4.0 ml") !=
        std::string::npos);
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

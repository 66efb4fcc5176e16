// Exercises in the main window: begun, followed, ended, scored.
#include <QApplication>
#include <QDesktopServices>
#include <QDockWidget>
#include <QFileDialog>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QUrl>
#include <algorithm>
#include <cmath>

#include "app/exercise/attempt_folder.h"
#include "app/exercise/exercise_panel.h"
#include "app/exercise/exercises_page.h"
#include "app/language/words.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/timeline_panel.h"
#include "base/error.h"
#include "io/output/atomic_file.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/task_writer.h"
#include "record/course.h"
#include "record/file/recording_file.h"
#include "skills/class/history.h"
#include "skills/report/task_page.h"
#include "skills/score/verdict.h"

namespace resect {
namespace {

// In the settings.
constexpr const char *kLearner = "learner", *kFolder = "attempts";
constexpr double kRest = 2;  // s without work after which an attempt ends that has reached its goal

// What is drawn to guide the hand to the goal; none for a goal that has no places.
std::optional<Guide> guideOf(const TaskGoal& goal, const AttemptProgress& progress,
                             const Aabb& organ) {
  using enum TaskGoal::Kind;
  constexpr double kVessel = 0.008;  // m: ring round a vessel that is to be divided
  Guide guide;
  guide.places = progress.places;
  guide.radius = goal.radius;
  guide.next = goal.kind == Touch ? progress.target : 0;
  if (goal.kind == Follow) guide.kind = Guide::Kind::Line;
  if (goal.kind == Divide) guide.radius = kVessel;
  if (goal.kind == Transect) {
    guide.kind = Guide::Kind::Plane;
    guide.normal = goal.normal;
    guide.box = organ.padded(0.005);
  }
  if (goal.kind == Resect && progress.structure) {
    guide.kind = Guide::Kind::Ball;
    guide.places = {*progress.structure};
    guide.radius = progress.structureRadius;
    guide.margin = goal.margin;
  }
  return guide.places.empty() ? std::nullopt : std::optional(guide);
}

}  // namespace

void MainWindow::makeExercises() {
  exercises_ = new ExercisesPage(this);
  exercises_->started = [this](const Exercise& exercise, TaskLevel level) {
    startExercise(exercise, level);
  };
  exercises_->aboutWanted = [this](const Exercise& exercise) { showAbout(exercise); };
  exercises_->closed = [this] { hideExercises(); };
  exercises_->learnerChosen = [this] {
    const QString name = QString::fromStdString(learnerName(exercises_->learner().toStdString()));
    if (name == QString::fromStdString(learner())) return;
    QSettings().setValue(kLearner, name);
    QTimer::singleShot(0, this, [this] { showExercises(); });
  };
  exercises_->folderWanted = [this] { chooseAttemptsFolder(); };
  exercises_->classWanted = [this](bool names) { tabulateClass(names); };
  exercises_->addWanted = [this] {
    const QString file = QFileDialog::getOpenFileName(this, Words::tr("Add an exercise"), {},
                                                      Words::tr("Exercises (*.toml)"));
    if (file.isEmpty()) return;
    try {
      addExercise(file.toStdString());
      showExercises();
    } catch (const std::exception& e) {
      complain(e.what());
    }
  };
  exercises_->makeWanted = [this] { openMaker(); };
  exercise_->finished = [this] { endExercise("Finished."); };
  exercise_->restarted = [this] {
    if (!session_) return;
    startedAsTest_ = asTest_;
    load(session_->scenario());
  };
  exercise_->exercisesWanted = [this] { showExercises(); };
  exercise_->nextWanted = [this] { isDraft() ? showMaker() : nextExercise(); };
  exercise_->pageWanted = [this] { openPage(page_); };
  exercise_->evidenceChosen = [this](double seconds) { replayFrom(seconds); };
  makeMaker();
}

std::filesystem::path MainWindow::attemptsFolder() const {
  const std::string chosen = QSettings().value(kFolder).toString().toStdString();
  return chosen.empty() ? usualAttemptsFolder() : std::filesystem::path(chosen);
}

std::string MainWindow::learner() const {
  return learnerName(QSettings().value(kLearner, "learner").toString().toStdString());
}

void MainWindow::showExercises() {
  std::vector<std::string> complaints;
  const std::vector<Exercise> exercises = allExercises(complaints);
  std::vector<HistoryEntry> done;
  try {
    done = attemptsOf(attemptsFolder(), learner());
  } catch (const Error& e) {
    complaints.push_back(e.what());
  }
  QStringList learners;
  for (const std::string& name : learnersIn(attemptsFolder()))
    learners << QString::fromStdString(name);
  placeOverlays();
  exercises_->show(exercises, done, learners, QString::fromStdString(learner()),
                   QString::fromStdString(attemptsFolder().string()));
  for (const std::string& one : complaints) complain(one);
  if (options_.reports)
    QTimer::singleShot(200, this, [this] {
      reportButtons(exercises_);
      say("exercises shown");
    });
}

void MainWindow::hideExercises() {
  exercises_->hide();
  viewer_->setFocus();
  if (options_.reports) say("exercises hidden");
}

// The page of what an exercise teaches; kept beside the attempts, where a browser can read it.
void MainWindow::showAbout(const Exercise& exercise) {
  try {
    const std::string page = taskPage(readScenario(exercise.file));
    const std::filesystem::path file = attemptsFolder() / ("about-" + exercise.name + ".html");
    std::filesystem::create_directories(file.parent_path());
    writeFileAtomically(file, [&](std::ostream& out) { out << page; });
    openPage(file);
  } catch (const std::exception& e) {
    complain(e.what());
  }
}

void MainWindow::startExercise(const Exercise& exercise, TaskLevel level) {
  try {
    Scenario scenario = readScenario(exercise.file);
    if (!scenario.task) throw error("{}: has no task any more", exercise.file.string());
    scenario.task = atLevel(*scenario.task, level);
    startedAsTest_ = exercises_->asTest();
    if (load(scenario)) hideExercises();
  } catch (const std::exception& e) {
    complain(e.what());
  }
}

// A new operation has begun; it is an exercise if its scenario has a task.
void MainWindow::beginExercise() {
  scorer_.leave();
  waitsForHand_ = attempt_ != nullptr;
  attemptEnded_ = afterExercise_ = false;
  targetSaid_ = kNoTarget;
  replayUntil_ = -1;
  if (!isDraft() && !makerDock_->isHidden()) closeMaker();
  asTest_ = std::exchange(startedAsTest_, false);
  // The exercise's panel has what that of the operation says.
  if (!attempt_ && !exerciseDock_->isHidden()) traineePanels_[0]->show();
  if (attempt_) traineePanels_[0]->hide();
  if (!makerDock_->isHidden()) traineePanels_[1]->show();
  exerciseDock_->setVisible(attempt_ != nullptr);
  if (!attempt_) return;
  const Task& task = *session_->scenario().task;
  const bool guided = task.guidance && task.level != TaskLevel::Hard && !asTest_;
  exercise_->begin(translated(session_->scenario().title), task, guided, session_->hasGhosts(),
                   isDraft());
  if (options_.reports)
    say("exercise {} level {} guidance {}", session_->scenario().name, wordOf(task.level),
        guided ? "on" : "off");
}

void MainWindow::followExercise(const LiveState& state) {
  if (replayUntil_ >= 0 && session_->answered() && state.showing) {
    const bool over = state.moment.frame >= replayUntil_;
    if (over || state.playback == 0) session_->setPlayback(over ? 0 : 1, attemptBranch_);
    if (over) replayUntil_ = -1;
  }
  if (attemptEnded_ && attempt_ && !session_->showing() && session_->answered()) {
    attemptEnded_ = false;
    afterExercise_ = true;
    attempt_.reset();
    session_->setGuide({});
    statusBar()->showMessage(Words::tr("The exercise is over: what is done now does not count"),
                             8000);
  }
  if (!exercising()) return;
  if (session_->tools().held() >= 0 || session_->playing()) waitsForHand_ = false;
  const Task& task = *session_->scenario().task;
  const AttemptProgress progress = attempt_->progress();
  guideHand(progress);
  const double seconds = double(state.moment.frame) / session_->scenario().frameRate;
  if (session_->showing()) return;
  if (options_.reports && progress.time > 0 && targetSaid_ != progress.target) {
    targetSaid_ = progress.target;
    reportPlaces();
    say("target {}", targetSaid_ + 1);
  }
  const auto most = mostOf(task, "total_time_s");
  const bool late = most && seconds > *most;
  // The rest after the work does not count.
  if (progress.reached && (progress.rested > kRest || late))
    return endExercise("The goal is reached.",
                       std::max(progress.since, progress.time - progress.rested));
  if (late) endExercise("The time is up.");
}

void MainWindow::guideHand(const AttemptProgress& progress) {
  const TaskGoal& goal = session_->scenario().task->goal;
  const std::optional<Guide> guide = guideOf(goal, progress, session_->cells().lattice.box());
  session_->setGuide(exercise_->guidance() ? guide : std::nullopt);
  session_->setGhosts(exercise_->ghosts());
  const std::optional<double> distance = session_->guideDistance();
  const LiveState& state = session_->state();
  exercise_->follow(state, double(state.moment.frame) / session_->scenario().frameRate, progress,
                    distance, guide && distance ? keepingOf(*guide, *distance) : Keeping::Far);
}

bool MainWindow::refusesGoingBack() {
  if (!exercising() || (session_->scenario().task->undo && !asTest_)) return false;
  statusBar()->showMessage(Words::tr("In this exercise no work is taken back"), 5000);
  if (options_.reports) say("going back refused");
  return true;
}

// The exercise is given up.
void MainWindow::endExerciseUnscored() {
  scorer_.leave();
  attempt_.reset();
  session_->setGuide({});
  session_->setGhosts(false);
  exerciseDock_->hide();
}

// The attempt is over: it is kept, scored, and stays to be looked at.
// why: in English. end: s from the start, after which nothing counts; none: now.
void MainWindow::endExercise(const std::string& why, std::optional<double> end) {
  if (!exercising()) return;
  attemptEnded_ = true;  // the guide stays, for what is looked at again
  attemptEndedAt_ = QDateTime::currentMSecsSinceEpoch();
  session_->setGhosts(false);
  if (options_.reports) say("exercise ended: {}", why);
  try {
    if (!recorder_)
      throw error("This attempt could not be recorded, so it cannot be scored. Begin it again.");
    const std::string name = learner(), exercise = session_->scenario().name;
    // Attempts at an exercise that is being made stay beside it.
    const std::filesystem::path folder =
        isDraft() ? std::filesystem::path(session_->scenario().file).parent_path()
                  : attemptsFolder();
    const std::filesystem::path recording = newAttempt(folder, name, exercise);
    page_ = recording;
    page_.replace_extension(".html");
    attemptBranch_ = session_->state().moment.branch;
    const std::int64_t last =
        end ? std::llround(std::ceil(*end * session_->scenario().frameRate)) : kEndOfBranch;
    recorder_->saveAs(recording, {attemptBranch_, last});
    session_->show(session_->state().moment);  // nothing happens any more
    exercise_->showEnd(translated(why));
    const AttemptScorer::Attempt attempt{recording, page_, historyIn(folder), name,
                                         asTest_ || isDraft()};
    const std::optional<AttemptResult> now = resultNow(attempt);
    if (now) showResult(*now);
    scorer_.score(
        attempt,
        [this, now](const AttemptResult& result) {
          if (!now || !agree(*now, result)) showResult(result);
          if (now && options_.reports && !agree(*now, result)) say("result changed");
          if (isDraft()) keepTry(result);
        },
        [this] {
          exercise_->showPage();
          if (!options_.reports) return;
          reportButtons(exercise_);
          say("report written");
        },
        [this](const QString& sentence) {
          exercise_->showFailure(Words::tr("The attempt is kept, but could not be scored."));
          complain(sentence.toStdString());
        });
  } catch (const std::exception& e) {
    exercise_->showFailure(translated(std::string(e.what()), kLongestSentence));
    complain(e.what());
  }
}

// The result as the operation itself knows it, so that nobody waits until the recording has been
// played again; none if work was taken back.
std::optional<AttemptResult> MainWindow::resultNow(const AttemptScorer::Attempt& attempt) {
  RecordingFile file = RecordingFile::open(attempt.recording);
  const std::vector<CourseSpan> course = courseTo(file, file.moment());
  if (course.size() != 1) return {};
  std::optional<Attempt> done;
  session_->operation().look(
      [&](const Simulation& simulation) { done = attempt_->end(course.front().last, simulation); });
  if (!done) return {};
  done->file = attempt.recording.string();
  done->learner = attempt.learner;
  LearnerHistory history(attempt.history);
  const bool graded = attempt.graded || !done->task->familiarisation ||
                      history.hasTried(done->learner, done->scenario);
  const Scored scored = score(std::move(*done), {}, graded);
  history.keep(historyEntry(scored, scoreKey(attempt.recording, {}, {})));
  return resultOf(scored);
}

void MainWindow::showResult(const AttemptResult& result) {
  exercise_->showResult(result);
  std::vector<TimelinePanel::Mark> marks;
  for (std::size_t i = 0; i < result.evidence.size(); ++i)
    if (const Evidence& one = result.evidence[i]; one.time)
      marks.push_back({std::llround(*one.time * timeline_->frameRate()), QString::number(i + 1),
                       translated(one.fact)});
  timeline_->setMarks(std::move(marks));
  QTimer::singleShot(0, this, [this] { arrangePanels(); });
  if (!options_.reports) return;
  say("result {} score {:.2f}: {}", result.passed ? "passed" : "failed", result.score,
      result.reason.toStdString());
}

// Shows the moment again, from a little before it to a little after it.
void MainWindow::replayFrom(double seconds) {
  if (!session_ || !session_->state().timeline) return;
  constexpr double kBefore = 1.5, kAfter = 1;  // s
  const double rate = session_->scenario().frameRate;
  const auto frameAt = [&](double time) {
    return std::max<std::int64_t>(0, std::llround(time * rate));
  };
  session_->setPlayback(0, attemptBranch_);
  session_->show(session_->state().timeline->momentOn(attemptBranch_, frameAt(seconds - kBefore)));
  session_->setPlayback(1, attemptBranch_);
  replayUntil_ = frameAt(seconds + kAfter);
  viewer_->setFocus();
}

void MainWindow::nextExercise() {
  std::vector<std::string> complaints;
  const std::vector<Exercise> all = allExercises(complaints);
  if (!session_ || !session_->scenario().task || all.empty()) return;
  const auto at = std::ranges::find(all, session_->scenario().name, &Exercise::name);
  const std::size_t next = at == all.end() ? 0 : std::size_t(at - all.begin() + 1) % all.size();
  startExercise(all[next], session_->scenario().task->level);
}

void MainWindow::chooseAttemptsFolder() {
  const QString folder = QFileDialog::getExistingDirectory(
      this, Words::tr("Folder for attempts"), QString::fromStdString(attemptsFolder().string()));
  if (folder.isEmpty()) return;
  QSettings().setValue(kFolder, folder);
  showExercises();
}

void MainWindow::tabulateClass(bool names) {
  const std::filesystem::path page = attemptsFolder() / "class.html";
  exercises_->say(Words::tr("The class is being scored ..."));
  scorer_.tabulate(
      attemptsFolder(), page, historyIn(attemptsFolder()), names,
      [this, page] {
        exercises_->say("");
        openPage(page);
      },
      [this](const QString& sentence) {
        exercises_->say("");
        complain(sentence.toStdString());
      });
}

void MainWindow::openPage(const std::filesystem::path& page) {
  if (options_.reports) return say("open {}", page.string());
  if (QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(page.string())))) {
    const QString sentence =
        Words::tr("A browser should show it now; the file is %1").arg(shown(page.string()));
    statusBar()->showMessage(sentence, 15000);
    if (exercises_->isVisible()) exercises_->say(sentence);
  } else
    complain(page.string() + ": no browser could be started; open this file in one");
}

}  // namespace resect

#include "app/main_window.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <fmt/format.h>

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/exercise/exercise_panel.h"
#include "app/exercise/exercises_page.h"
#include "app/language/words.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/banner.h"
#include "app/widgets/controls_overlay.h"
#include "app/widgets/instruments_panel.h"
#include "app/widgets/panels.h"
#include "app/widgets/theme.h"
#include "app/widgets/timeline_panel.h"
#include "base/error.h"
#include "blood/flow/circulation.h"
#include "formats/png_file.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/scene_file.h"
#include "operation/blood/dangers.h"
#include "record/session_recordings.h"

namespace resect {
namespace {

LeftTool leftTool(OperatingSession& session, int tool) {
  constexpr double kWaits = 1, kFelt = 0.01;  // s, N
  const LiveState& state = session.state();
  const auto i = std::size_t(tool);
  if (!session.tools().isLeft(tool) || i >= state.lastTouch.size()) return LeftTool::No;
  // A hook that has slipped off often still leans on the tissue.
  const ToolModel& model = session.toolModels()[i];
  const bool holds = !model.hook.empty() || model.kind == "forceps";
  const double touched = state.lastTouch[i];
  const bool touches =
      session.showing() ? state.forces[i] > kFelt : touched >= 0 && state.time - touched < kWaits;
  if (holds ? state.grips[i] != 0 : touches) return LeftTool::Works;
  // A scenario's instruments wait in the air between their tasks.
  if (session.playing() || session.showing()) return LeftTool::No;
  // Others may work without touching tissue, as suction does.
  return holds ? LeftTool::TouchesNothing : LeftTool::Works;
}

constexpr qint64 kPanelInterval = 150;  // ms between updates of the panels

const char* nameOf(ToolHandling::Hold how) {
  switch (how) {
    case ToolHandling::Hold::None:
      return "none";
    case ToolHandling::Hold::Direct:
      return "direct";
    case ToolHandling::Hold::Guided:
      return "guided";
    case ToolHandling::Hold::HandleBox:
      return "handle-box";
    case ToolHandling::Hold::Trackball:
      return "trackball";
  }
  return "";
}

// Whether the event is the press of a button or key.
bool isPress(const SoEvent& event) {
  return event.isOfType(SoButtonEvent::getClassTypeId()) &&
         static_cast<const SoButtonEvent&>(event).getState() == SoButtonEvent::DOWN;
}

}  // namespace

MainWindow::MainWindow(const WindowOptions& options) : options_(options) {
  setWindowTitle("Resect");
  setAcceptDrops(true);
  viewer_ = new Viewer(this);
  viewer_->setFpsLimit(options.fpsLimit);
  viewer_->ticked = [this] { tick(); };
  viewer_->before = [this](const SoEvent& event, const SbViewportRegion& viewport) {
    return viewerEvent(event, viewport);
  };

  complaint_ = new Banner(this);
  overlay_ = new ControlsOverlay(viewer_);
  progress_ = new QProgressBar(this);
  progress_->setMaximumWidth(220);
  cancel_ = new QPushButton(Words::tr("Cancel"), this);
  cancel_->setFocusPolicy(Qt::TabFocus);
  recording_ = new QLabel("<span style='color:#e0483c'>&#9679;</span> " + Words::tr("Recording"));
  recording_->setToolTip(Words::tr("A film is being recorded: Ctrl+R ends it and writes it"));
  recording_->hide();
  notRecorded_ = new QLabel(Words::tr("Not recorded"));
  notRecorded_->setToolTip(
      Words::tr("This operation is kept in no file: File > Recorded operations"));
  notRecorded_->hide();
  statusBar()->addPermanentWidget(notRecorded_);
  statusBar()->addPermanentWidget(recording_);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
  progress_->hide();
  cancel_->hide();
  progress_->setToolTip(Words::tr("How much of it has been made"));
  cancel_->setToolTip(Words::tr("Gives up what is coming; what is there stays as it is"));
  connect(cancel_, &QPushButton::clicked, this, [this] { cancelLoading(); });
  spaceMouse_.pushed = [this](const SixAxes& axes, double seconds) {
    if (session_) session_->follow(motionOf(axes, seconds));
  };
  makeDocks();
  makeExercises();
  makeMenus();
  qApp->installEventFilter(this);
  resize(QSize(options.width, options.height).boundedTo(screen()->availableSize()));
  QSettings settings;
  dark_->setChecked(options.dark.value_or(settings.value("dark", true).toBool()));
  setTheme(dark_->isChecked());
  connect(dark_, &QAction::toggled, this, [this](bool on) {
    setTheme(on);
    QSettings().setValue("dark", on);
  });
  if (options.reports) listenToScript();
  if (options.operation.empty())
    load(options.scenario);
  else
    openOperation(QString::fromStdString(options.operation));
  if (options.exercises) showExercises();
}

MainWindow::~MainWindow() {
  viewer_->show(nullptr);
  viewer_->ticked = {};
}

// In each tick, since a click may be short.
void MainWindow::sayWhatIsClosed(const LiveState& state) {
  const int held = session_->tools().held();
  const auto nameOf = [this](std::int32_t organ, std::int32_t segment) {
    std::string name;
    session_->operation().look([&](const Simulation& s) {
      name = s.organs()[std::size_t(organ)].organ.map->nameOf(segment);
    });
    return name;
  };
  for (HaemostasisWatch& watch : haemostasis_) {
    const auto worker = session_->playing()    ? HaemostasisWatch::Worker::Scenario
                        : held == watch.tool() ? HaemostasisWatch::Worker::Hand
                                               : HaemostasisWatch::Worker::Nobody;
    tell(watch.follow(state, worker, nameOf));
  }
}

void MainWindow::sayHowThePatientIs(const LiveState& state) {
  const int grade = haemorrhageClass(state.bled);
  const bool now = !state.showing;  // not of an earlier moment
  if (now && grade > haemorrhage_ && grade > 1)
    tell(Words::tr("The patient has lost %1 ml, %2 % of the blood: haemorrhage of class %3 of 4")
             .arg(1e6 * state.bled, 0, 'f', 0)
             .arg(std::lround(100 * state.bled / Circulation{}.volume))
             .arg(grade));
  haemorrhage_ = grade;
  if (now && state.inflowClamped != clampSaid_)
    tell(state.inflowClamped ? Words::tr("The inflow of the liver is closed")
                             : Words::tr("The inflow of the liver is open again"));
  clampSaid_ = state.inflowClamped;
}

// In the panel; and that an instrument which was left at work holds nothing is told once.
void MainWindow::sayWhatHolds() {
  std::vector<LeftTool> left;
  for (int i = 0; i < session_->tools().toolCount(); ++i) {
    left.push_back(leftTool(*session_, i));
    const auto k = std::size_t(i);
    if (left[k] == LeftTool::TouchesNothing && leftTools_[k] != LeftTool::TouchesNothing)
      tell(Words::tr("%1 holds nothing: it slipped off, or met no tissue. Take it again.")
               .arg(translated(session_->toolModels()[k].name)));
  }
  leftTools_ = std::move(left);
  instruments_->show(heldSaid_, leftTools_);
}

// In the line below the picture.
void MainWindow::tell(const QString& sentence) {
  if (sentence.isEmpty()) return;
  statusBar()->showMessage(sentence, 8000);
  if (options_.reports) say("told {}", sentence.toStdString());
}

// The time of the operation stands still behind the cards of the exercises, until an exercise's
// first instrument is taken, and while a menu or a dialog is open.
void MainWindow::keepTime() {
  const bool menu = QApplication::activePopupWidget() != nullptr;
  session_->operation().setPaused(exercises_->isVisible() || waitsForHand_ || menu ||
                                  QApplication::activeModalWidget());
  // Qt leaves the keys with the bar of menus after Escape; they belong to the picture.
  if (menuOpen_ && !menu && menuBar()->hasFocus()) viewer_->setFocus();
  menuOpen_ = menu;
}

void MainWindow::tick() {
  if (!session_) return;
  keepTime();
  const qint64 now = QDateTime::currentMSecsSinceEpoch();
  const ToolHandling& tools = session_->tools();
  if (tools.held() != heldSaid_ || tools.how() != howSaid_) {
    heldSaid_ = tools.held();
    howSaid_ = tools.how();
    if (options_.reports)
      say("held {} {}",
          heldSaid_ < 0 ? "nothing" : session_->toolModels()[std::size_t(heldSaid_)].name,
          nameOf(howSaid_));
  }
  if (tools.left() != leftSaid_) {
    leftSaid_ = tools.left();
    std::string names;
    for (int i = 0; i < tools.toolCount(); ++i)
      if (tools.isLeft(i)) names += " " + session_->toolModels()[std::size_t(i)].name;
    if (options_.reports) say("left{}", names.empty() ? " nothing" : names);
  }
  const LiveState& state = session_->state();
  sayWhatHolds();
  speaker_.follow(state, session_->toolModels(), tools.pedalling() ? tools.held() : -1);
  if (options_.reports && state.removed != removedSaid_) {
    removedSaid_ = state.removed;
    say("removed {}", removedSaid_);
  }
  constexpr qint64 kFaultShown = 10000;  // ms
  for (const std::string& fault : state.faults) {
    faultSeen_ = now;
    if (fault != faultSaid_)
      complain(faultSaid_ = fault,
               [this] { return QDateTime::currentMSecsSinceEpoch() - faultSeen_ < kFaultShown; });
  }
  if (now - faultSeen_ > kFaultShown) faultSaid_.clear();
  if (const std::string failure = recorder_ ? recorder_->failure() : ""; failure != recorderSaid_) {
    recorderSaid_ = failure;
    if (!failure.empty())
      complain(failure + "; the operation goes on unrecorded",
               [this] { return recorder_ && !recorder_->failure().empty(); });
  }
  if (complaint_->leaves() && options_.reports) say("error gone");
  film(now);
  if (options_.reports && !pictureSaid_ && viewer_->showsPicture()) {
    pictureSaid_ = true;
    say("picture");
  }
  if (options_.reports && playingSaid_ && !session_->playing()) say("played");
  playingSaid_ = session_->playing();
  if (options_.reports) reportMoment();
  if (options_.reports) reportPace();
  sayWhatIsClosed(state);
  sayHowThePatientIs(state);
  if (now - panelsShown_ < kPanelInterval) return;
  panelsShown_ = now;
  followPanels(state, now);
  followExercise(state);
  if (state.timeline && strokesNoted_ != state.timeline->strokeCount()) noteRecording();
  if (!options_.reports || (state.frame == 0 && !waitsForHand_)) return;
  // After the layout of the panels is final.
  const QSize size = viewer_->size();
  if (size == lastSize_ && size != placesSize_) {
    reportPlaces();
    placesSize_ = size;
    if (!readySaid_) say("ready");
    readySaid_ = true;
  }
  lastSize_ = size;
}

// Name of the instrument in hand; empty if there is none.
QString MainWindow::heldName() const {
  const int held = session_->tools().held();
  return held < 0 ? QString() : translated(session_->toolModels()[std::size_t(held)].name);
}

bool MainWindow::viewerEvent(const SoEvent& event, const SbViewportRegion& viewport) {
  if (overlay_->isVisible() && isPress(event)) overlay_->hide();
  complaint_->userWentOn();
  // A hand that was about to work when the exercise ended begins no new branch.
  constexpr qint64 kSeesTheEnd = 1500;  // ms
  if (attempt_ && attemptEnded_ && isPress(event) &&
      event.isOfType(SoMouseButtonEvent::getClassTypeId()) &&
      QDateTime::currentMSecsSinceEpoch() - attemptEndedAt_ < kSeesTheEnd)
    return true;
  // Out of the past, not the instrument into the tool box.
  if (session_ && session_->showing() && !timeline_->atEnd() && isPress(event) &&
      event.isOfType(SoKeyboardEvent::getClassTypeId()) &&
      static_cast<const SoKeyboardEvent&>(event).getKey() == SoKeyboardEvent::ESCAPE) {
    timeline_->toEnd();
    return true;
  }
  if ((!lookingAt_ && !marking_) || !session_ ||
      !event.isOfType(SoMouseButtonEvent::getClassTypeId()))
    return false;
  const auto& mouse = static_cast<const SoMouseButtonEvent&>(event);
  if (mouse.getState() != SoButtonEvent::DOWN) return false;
  if (marking_) {
    if (mouse.getButton() != SoMouseButtonEvent::BUTTON1) return false;
    markPlace(event.getPosition(), viewport);
    return true;
  }
  lookingAt_ = false;
  viewer_->unsetCursor();
  statusBar()->clearMessage();
  if (const auto under = session_->pointUnder(event.getPosition(), viewport))
    session_->camera().lookAt(under->point);
  return true;
}

bool MainWindow::hasMotions() const {
  return std::ranges::any_of(session_->scenario().tools,
                             [](const ScenarioTool& tool) { return !tool.keys.empty(); });
}

void MainWindow::play(double until) {
  if (!session_) return;
  if (!hasMotions()) return complain("There is no motion to play; open a scenario that has one.");
  session_->play(until);
}

void MainWindow::look(RoomView view) {
  if (!session_) return;
  session_->look(view, viewer_->aspect());
  if (options_.reports) reportPlaces();
}

void MainWindow::viewAll() {
  if (!session_) return;
  session_->viewAll(viewer_->aspect());
  if (options_.reports) reportPlaces();
}

void MainWindow::bringEverythingBack() {
  activateWindow();
  viewer_->setFocus();  // else a panel may still take the keys
  if (!session_) return;
  session_->bringEverythingBack(viewer_->aspect());
  if (options_.reports) reportPlaces();
}

void MainWindow::complain(const std::string& sentence, std::function<bool()> holds) {
  if (options_.reports) say("error {}", sentence);
  complaint_->say(translated(sentence, kLongestSentence), std::move(holds));
  placeOverlays();
}

void MainWindow::placeOverlays() {
  const int top = menuBar()->height();
  exercises_->setGeometry(0, top, width(), height() - top);
  overlay_->setGeometry(viewer_->rect());
  complaint_->place({viewer_->mapTo(this, QPoint(0, 0)), viewer_->size()});
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  placeOverlays();
}

}  // namespace resect

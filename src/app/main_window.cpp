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
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/controls_overlay.h"
#include "app/widgets/instruments_panel.h"
#include "app/widgets/panels.h"
#include "app/widgets/theme.h"
#include "app/widgets/timeline_panel.h"
#include "base/error.h"
#include "formats/png_file.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/scene_file.h"
#include "record/session_recordings.h"

namespace resect {
namespace {

constexpr qint64 kPanelInterval = 150;  // ms between updates of the panels
constexpr int kTallWindow = 900;        // pixels: in a lower one forces and timing share one place

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

// "Wheel: 10 mm deep" of the guided tool in hand, as a line of its own.
QString depthOf(const ToolHandling& tools) {
  return QString("\nWheel: %1 mm deep").arg(std::lround(1e3 * tools.depth(tools.held())));
}

// What can be done next with the instrument in hand.
QString sentenceOf(const ToolHandling& tools, const QString& name) {
  switch (tools.how()) {
    case ToolHandling::Hold::None:
      return "Take an instrument: click it, or press its number.";
    case ToolHandling::Hold::Direct:
      return name + " in hand: drag, wheel, Shift turns.";
    case ToolHandling::Hold::Guided:
      if (tools.pressing()) return name + " at work; F leaves it there." + depthOf(tools);
      return name + ": press and draw." + depthOf(tools);
    case ToolHandling::Hold::HandleBox:
      return name + " in a handle box: middle click to turn.";
    case ToolHandling::Hold::Trackball:
      return name + " in a trackball: middle click to move.";
  }
  return {};
}

// The first tool in hand in the motions being played; -1 for none.
int playedTool(const LiveState& state) {
  const auto at = std::ranges::find_if(state.played, &ToolInput::inHand);
  return at == state.played.end() ? -1 : int(at - state.played.begin());
}

// Whether the event is the press of a button or key.
bool isPress(const SoEvent& event) {
  return event.isOfType(SoButtonEvent::getClassTypeId()) &&
         static_cast<const SoButtonEvent&>(event).getState() == SoButtonEvent::DOWN;
}

// The tool in hand or left at work on which the force is largest; -1 for none.
int workingTool(const LiveState& state) {
  int strongest = -1;
  for (std::size_t i = 0; i < state.inHand.size(); ++i)
    if (state.inHand[i] &&
        (strongest < 0 || state.forces[i] > state.forces[std::size_t(strongest)]))
      strongest = int(i);
  return strongest;
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
  setCentralWidget(viewer_);

  complaint_ = new QPushButton(this);
  complaint_->setStyleSheet(
      "QPushButton { background: #7a2a22; color: white; border: 0; border-radius: 6px; "
      "padding: 8px 14px; text-align: left; }");
  complaint_->setToolTip("Click to close");
  complaint_->setFocusPolicy(Qt::TabFocus);
  complaint_->hide();
  connect(complaint_, &QPushButton::clicked, complaint_, &QWidget::hide);
  overlay_ = new ControlsOverlay(viewer_);
  progress_ = new QProgressBar(this);
  progress_->setMaximumWidth(220);
  cancel_ = new QPushButton("Cancel", this);
  cancel_->setFocusPolicy(Qt::TabFocus);
  recording_ = new QLabel("<span style='color:#e0483c'>&#9679;</span> Recording");
  recording_->setToolTip("A film is being recorded: Ctrl+R ends it and writes it");
  recording_->hide();
  notRecorded_ = new QLabel("Not recorded");
  notRecorded_->setToolTip("This operation is kept in no file: File > Recorded operations");
  notRecorded_->hide();
  statusBar()->addPermanentWidget(notRecorded_);
  statusBar()->addPermanentWidget(recording_);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
  progress_->hide();
  cancel_->hide();
  progress_->setToolTip("How much of it has been made");
  cancel_->setToolTip("Gives up what is coming; what is there stays as it is");
  connect(cancel_, &QPushButton::clicked, this, [this] { cancelLoading(); });
  spaceMouse_.pushed = [this](const SixAxes& axes, double seconds) {
    if (session_) session_->follow(motionOf(axes, seconds));
  };
  makeDocks();
  makeMenus();
  qApp->installEventFilter(this);
  resize(options.width, options.height);
  QSettings settings;
  dark_->setChecked(options.dark.value_or(settings.value("dark", true).toBool()));
  setTheme(dark_->isChecked());
  connect(dark_, &QAction::toggled, this, [this](bool on) {
    setTheme(on);
    QSettings().setValue("dark", on);
  });
  if (options.overlay && !settings.value("controls_seen").toBool()) {
    overlay_->show();
    settings.setValue("controls_seen", true);
  }
  if (options.reports) listenToScript();
  if (options.operation.empty())
    load(options.scenario);
  else
    openOperation(QString::fromStdString(options.operation));
}

MainWindow::~MainWindow() {
  viewer_->show(nullptr);
  viewer_->ticked = {};
}

void MainWindow::makeDocks() {
  const auto dock = [&](const char* title, QWidget* content) {
    auto* widget = new QDockWidget(title, this);
    widget->setObjectName(title);
    widget->setWidget(content);
    addDockWidget(Qt::RightDockWidgetArea, widget);
  };
  instruments_ = new InstrumentsPanel;
  organ_ = new OrganPanel;
  removed_ = new RemovedPanel;
  force_ = new ForcePanel;
  timing_ = new TimingPanel;
  timeline_ = new TimelinePanel;
  dock("Instruments", instruments_);
  dock("Organ", organ_);
  dock("Removed", removed_);
  dock("Force", force_);
  auto* stages = new QScrollArea;  // may be higher than the window
  stages->setFrameShape(QFrame::NoFrame);
  stages->setWidgetResizable(true);
  stages->setFocusPolicy(Qt::NoFocus);
  stages->setWidget(timing_);
  dock("Timing", stages);
  auto* below = new QDockWidget("Timeline", this);
  below->setObjectName("Timeline");
  below->setWidget(timeline_);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  addDockWidget(Qt::BottomDockWidgetArea, below);
  auto* force = static_cast<QDockWidget*>(force_->parentWidget());
  force->hide();  // until tissue moves and exerts forces
  if (options_.height < kTallWindow)
    tabifyDockWidget(force, static_cast<QDockWidget*>(stages->parentWidget()));
  // Fixed width from the start, so that the picture does not shift when numbers appear.
  QList<QDockWidget*> docks = findChildren<QDockWidget*>();
  docks.removeOne(below);
  resizeDocks(docks, QList<int>(docks.size(), 32 * fontMetrics().averageCharWidth()),
              Qt::Horizontal);
  // In lines of text.
  QList<int> heights;
  for (const int lines : {9, 14, 9, 6, 19}) heights.push_back(lines * fontMetrics().height());
  resizeDocks(docks, heights, Qt::Vertical);
  instruments_->chosen = [this](int tool) {
    if (!session_) return;
    if (tool == session_->tools().held())
      session_->tools().putBack(tool);
    else
      session_->tools().take(tool);
    viewer_->setFocus();
  };
  organ_->isoChanged = [this](float iso) {
    if (!session_) return;
    session_->setIso(iso);
  };
  organ_->rebuild = [this](std::optional<double> spacing, int refine, bool elastic) {
    if (!session_) return;
    Scenario scenario = session_->scenario();
    // The files from which an opened operation was made need not be here; its recording has all.
    if (!madeFrom_.empty() && !spacing && refine == scenario.organs[0].source.settings.refine &&
        elastic == scenario.organs[0].tissue.elastic)
      return openOperation(QString::fromStdString(madeFrom_), true);
    if (spacing) setSpacing(scenario, session_->cells().lattice.spacing.x(), *spacing);
    for (ScenarioOrgan& organ : scenario.organs) organ.source.settings.refine = refine;
    if (elastic != scenario.organs[0].tissue.elastic)
      elastic ? makeElastic(scenario) : makeStill(scenario);
    if (load(scenario)) keepsView_ = true;
  };
}

void MainWindow::tick() {
  if (!session_) return;
  const qint64 now = QDateTime::currentMSecsSinceEpoch();
  const ToolHandling& tools = session_->tools();
  if (tools.held() != heldSaid_ || tools.how() != howSaid_) {
    heldSaid_ = tools.held();
    howSaid_ = tools.how();
    if (options_.reports) say("held {} {}", heldName("nothing").toStdString(), nameOf(howSaid_));
  }
  if (tools.left() != leftSaid_) {
    leftSaid_ = tools.left();
    std::string names;
    for (int i = 0; i < tools.toolCount(); ++i)
      if (tools.isLeft(i)) names += " " + session_->toolModels()[std::size_t(i)].name;
    if (options_.reports) say("left{}", names.empty() ? " nothing" : names);
  }
  instruments_->show(heldSaid_, tools.left(), sentenceOf(tools, heldName("")));
  const LiveState& state = session_->state();
  if (options_.reports && state.removed != removedSaid_) {
    removedSaid_ = state.removed;
    say("removed {}", removedSaid_);
  }
  for (const std::string& fault : state.faults)
    if (fault != faultSaid_) complain(faultSaid_ = fault);
  if (const std::string failure = recorder_ ? recorder_->failure() : ""; failure != recorderSaid_) {
    recorderSaid_ = failure;
    if (!failure.empty()) complain(failure + "; the operation goes on unrecorded");
  }
  film(now);
  if (options_.reports && playingSaid_ && !session_->playing()) say("played");
  playingSaid_ = session_->playing();
  if (options_.reports) reportMoment();
  if (options_.reports) reportPace();
  if (now - panelsShown_ < kPanelInterval) return;
  panelsShown_ = now;
  organ_->follow(state);
  organ_->setIso(session_->iso().value());
  removed_->follow(state);
  if (movesSaid_ != state.moves) {
    movesSaid_ = state.moves;
    force_->parentWidget()->setVisible(state.moves);
    if (state.moves)
      force_->parentWidget()->raise();  // above the timing, where they share one place
  }
  if (state.moves)
    force_->follow(state, session_->playing() ? playedTool(state) : workingTool(state));
  timing_->follow(state, viewer_->drawing(), session_->scenario().frameRate);
  timeline_->follow(state, session_->showing(), session_->answered());
  if (state.timeline && strokesNoted_ != state.timeline->strokeCount()) noteRecording();
  if (!options_.reports || state.frame == 0) return;
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

// Name of the instrument in hand, `none` if there is none.
QString MainWindow::heldName(const char* none) const {
  const int held = session_->tools().held();
  return held < 0 ? QString(none) : shown(session_->toolModels()[std::size_t(held)].name);
}

bool MainWindow::viewerEvent(const SoEvent& event, const SbViewportRegion& viewport) {
  if (overlay_->isVisible() && isPress(event)) overlay_->hide();
  // Out of the past, not the instrument into the tool box.
  if (session_ && session_->showing() && !timeline_->atEnd() && isPress(event) &&
      event.isOfType(SoKeyboardEvent::getClassTypeId()) &&
      static_cast<const SoKeyboardEvent&>(event).getKey() == SoKeyboardEvent::ESCAPE) {
    timeline_->toEnd();
    return true;
  }
  if (!lookingAt_ || !session_ || !event.isOfType(SoMouseButtonEvent::getClassTypeId()))
    return false;
  const auto& mouse = static_cast<const SoMouseButtonEvent&>(event);
  if (mouse.getState() != SoButtonEvent::DOWN) return false;
  lookingAt_ = false;
  viewer_->unsetCursor();
  statusBar()->clearMessage();
  if (const auto under = session_->pointUnder(event.getPosition(), viewport))
    session_->camera().lookAt(under->point);
  return true;
}

void MainWindow::play(double until) {
  if (!session_) return;
  const auto& tools = session_->scenario().tools;
  if (std::ranges::all_of(tools, [](const ScenarioTool& tool) { return tool.keys.empty(); }))
    return complain("There is no motion to play; open a scenario that has one.");
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

void MainWindow::complain(const std::string& sentence) {
  if (options_.reports) say("error {}", sentence);
  complaint_->setText(shown(sentence, kLongestSentence));
  complaint_->show();
  placeOverlays();
}

void MainWindow::placeOverlays() {
  overlay_->setGeometry(viewer_->rect());
  complaint_->setMaximumWidth(viewer_->width() - 40);
  complaint_->adjustSize();
  complaint_->move(viewer_->mapTo(this, QPoint(20, 14)));
  complaint_->raise();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  placeOverlays();
}

}  // namespace resect

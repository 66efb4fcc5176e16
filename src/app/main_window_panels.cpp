// What surrounds the picture in the main window: the line that says what to do, the panels of the
// operation, and those of the laboratory.
#include <QAction>
#include <QDockWidget>
#include <QScrollArea>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/advice/smooth_cells.h"
#include "app/exercise/exercise_panel.h"
#include "app/exercise/task_maker_panel.h"
#include "app/language/words.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/hint_bar.h"
#include "app/widgets/instruments_panel.h"
#include "app/widgets/operation_panel.h"
#include "app/widgets/panels.h"
#include "app/widgets/timeline_panel.h"

namespace resect {
namespace {

constexpr int kTallWindow = 1000;  // pixels: in a lower one the laboratory's panels share one place
constexpr int kPanelLetters = 33;  // width of the panels
constexpr int kWideLetters = 44;   // of those of exercises, which have sentences
constexpr double kShortestTold = 0.003;  // m: the length of a shorter stroke is not told

// A panel that may be higher than its place.
QScrollArea* scrolling(QWidget* content, int letters) {
  class Area : public QScrollArea {
   public:
    explicit Area(int letters) : letters_(letters) {}
    QSize sizeHint() const override {
      const QSize content = widget()->sizeHint();
      return {letters_ * fontMetrics().averageCharWidth(), content.height()};
    }
    QSize minimumSizeHint() const override {
      return {letters_ * fontMetrics().averageCharWidth(), 3 * fontMetrics().height()};
    }

   private:
    int letters_;
  };
  auto* area = new Area(letters);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(content);
  return area;
}

// How an instrument that follows the surface works while the left button is down.
QString useOf(const std::string& kind, const LiveState& state) {
  const bool dry = state.bleeds && state.bleedingEnds.empty();
  if (dry && kind == "clip_applier")
    return Words::tr("point at a vessel; hold the left button down half a second: it clips");
  if (dry && kind == "bipolar")
    return Words::tr(
        "point at a vessel or a raw surface; hold the left button down 2 s: they seal");
  if (!state.bleeds && (kind == "clip_applier" || kind == "inflow_clamp"))
    return Words::tr("there is nothing for it to close, since this organ has no vessels");
  constexpr std::pair<const char*, const char*> kUses[] = {
      {"scalpel", QT_TRANSLATE_NOOP("window", "press the left button and draw: it cuts")},
      {"hook", QT_TRANSLATE_NOOP("window", "press the left button and draw: it catches and pulls")},
      {"baton", QT_TRANSLATE_NOOP("window", "hold the left button down: it pushes")},
      {"scissors", QT_TRANSLATE_NOOP("window", "hold the left button down: they close")},
      {"suction",
       QT_TRANSLATE_NOOP(
           "window",
           "point at blood or a yellow ring, which marks what bleeds; hold the left button down")},
      {"clip_applier",
       QT_TRANSLATE_NOOP(
           "window",
           "point at a yellow ring, which marks what bleeds; press the left button: it clips")},
      {"bipolar", QT_TRANSLATE_NOOP("window",
                                    "point at a yellow ring, which marks what bleeds; hold the "
                                    "left button down 2 s: they seal")},
      {"gauze", QT_TRANSLATE_NOOP("window",
                                  "point at a yellow ring or a wound; hold the left button down: "
                                  "it presses, and soaks up")},
      {"inflow_clamp",
       QT_TRANSLATE_NOOP(
           "window",
           "hold the left button down beside the liver: it closes the inflow, or opens it again")},
      {"pencil", QT_TRANSLATE_NOOP("window",
                                   "press the left button and draw: it cuts, and seals what it "
                                   "cuts slowly; P coagulates only")},
      {"aspirator",
       QT_TRANSLATE_NOOP("window",
                         "press the left button and draw: it takes tissue and leaves vessels")},
      {"forceps",
       QT_TRANSLATE_NOOP("window", "press the left button and draw: they grasp and pull")}};
  const auto* use = std::ranges::find(kUses, kind, [](const auto& one) { return one.first; });
  return use == std::end(kUses) ? Words::tr("hold the left button down: it works")
                                : Words::tr(use->second);
}

// The first tool in hand in the motions being played; -1 for none.
int playedTool(const LiveState& state) {
  const auto at = std::ranges::find_if(state.played, &ToolInput::inHand);
  return at == state.played.end() ? -1 : int(at - state.played.begin());
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

void MainWindow::makeDocks() {
  hint_ = new HintBar;
  hint_->say(Words::tr("One moment ..."));
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(hint_);
  column->addWidget(viewer_, 1);
  setCentralWidget(middle);

  const auto dock = [&](const char* title, QWidget* content, int letters = kPanelLetters) {
    auto* made = new QDockWidget(Words::tr(title), this);
    made->setObjectName(title);
    made->setWidget(scrolling(content, letters));
    addDockWidget(Qt::RightDockWidgetArea, made);
    return made;
  };
  exercise_ = new ExercisePanel;
  operation_ = new OperationPanel;
  instruments_ = new InstrumentsPanel;
  organ_ = new OrganPanel;
  removed_ = new RemovedPanel;
  force_ = new ForcePanel;
  timing_ = new TimingPanel;
  timeline_ = new TimelinePanel;
  auto* curves = new QWidget;
  auto* both = new QVBoxLayout(curves);
  both->setContentsMargins(0, 0, 0, 0);
  both->addWidget(removed_, 1);
  both->addWidget(force_, 1);
  exerciseDock_ = dock(QT_TRANSLATE_NOOP("window", "Exercise"), exercise_, kWideLetters);
  maker_ = new TaskMakerPanel;
  makerDock_ = dock(QT_TRANSLATE_NOOP("window", "Maker"), maker_, kWideLetters);
  tabifyDockWidget(makerDock_, exerciseDock_);
  for (QDockWidget* hidden : {exerciseDock_, makerDock_}) hidden->hide();
  traineePanels_ = {dock(QT_TRANSLATE_NOOP("window", "Operation"), operation_),
                    dock(QT_TRANSLATE_NOOP("window", "Instruments"), instruments_)};
  laboratoryPanels_ = {dock(QT_TRANSLATE_NOOP("window", "Organ"), organ_),
                       dock(QT_TRANSLATE_NOOP("window", "Curves"), curves),
                       dock(QT_TRANSLATE_NOOP("window", "Timing"), timing_)};
  // In a low window they share one place.
  const bool tall = options_.height >= kTallWindow;
  if (!tall) tabifyDockWidget(laboratoryPanels_[0], laboratoryPanels_[1]);
  tabifyDockWidget(laboratoryPanels_[1], laboratoryPanels_[2]);
  for (QDockWidget* panel : laboratoryPanels_) panel->hide();
  auto* below = new QDockWidget(Words::tr("Timeline"), this);
  below->setObjectName("Timeline");
  below->setWidget(timeline_);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  addDockWidget(Qt::BottomDockWidgetArea, below);
  // Fixed width from the start, so that the picture does not shift when numbers appear.
  resizeDocks(traineePanels_, QList<int>(2, kPanelLetters * fontMetrics().averageCharWidth()),
              Qt::Horizontal);
  instruments_->chosen = [this](int tool) {
    if (!session_) return;
    if (tool == session_->tools().held())
      session_->tools().putBack(tool);
    else
      session_->tools().take(tool);
    viewer_->setFocus();
  };
  organ_->isoChanged = [this](float iso) {
    if (session_) session_->setIso(iso);
  };
  organ_->rebuild = [this](std::optional<double> spacing, int refine, bool elastic) {
    beginAgain(spacing, refine, elastic);
  };
  hint_->exercisesWanted = [this] { showExercises(); };
  hint_->accepted = [this](int millimetres) {
    if (!session_) return;
    const ScenarioOrgan& organ = session_->scenario().organs[0];
    beginAgain(1e-3 * millimetres, organ.source.settings.refine, organ.tissue.elastic);
  };
}

// The same scenario from its start. spacing: side of the cells, m; none: as it is.
void MainWindow::beginAgain(std::optional<double> spacing, int refine, bool elastic) {
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
}

// Shows the panels and the scale of the laboratory, or hides them.
void MainWindow::showLaboratory(bool shown) {
  for (QDockWidget* panel : laboratoryPanels_) panel->setVisible(shown);
  if (shown)
    for (const int front : {1, 0}) laboratoryPanels_[front]->raise();
  QTimer::singleShot(0, this, [this] { arrangePanels(); });
  scale_->setChecked(shown);
  timeline_->setLaboratory(shown);
  exercises_->raise();  // panels that appear would lie over it
  if (options_.reports) say("laboratory {}", shown ? "shown" : "hidden");
}

// Heights for what the panels show. What is left goes to the first panel, whose rows grow, or to
// the laboratory's. Called once they are laid out.
void MainWindow::arrangePanels() {
  const int told = operation_->explains() ? 8 : 0;
  const int operation = 13 + told, organ = 19;  // lines, with all rows that may appear
  const int line = fontMetrics().height();
  QList<QDockWidget*> panels = traineePanels_;
  QList<int> heights{operation * line, instruments_->sizeHint().height() + 2 * line};
  const bool wide = attempt_ || !makerDock_->isHidden();
  if (wide) panels[0] = attempt_ ? exerciseDock_ : makerDock_;
  if (attempt_) exerciseDock_->raise();
  if (laboratory_->isChecked()) {
    panels << laboratoryPanels_[0];
    heights << organ * line;
  }
  int others = 3 * line;  // menu, status
  for (const int height : heights) others += height;
  const bool laboratory = laboratory_->isChecked() && !wide;
  (laboratory ? heights.back() : heights.front()) += std::max(0, height() - others);
  resizeDocks(panels, heights, Qt::Vertical);
  const int letters = wide ? kWideLetters : kPanelLetters;
  resizeDocks({panels.front()}, {letters * fontMetrics().averageCharWidth()}, Qt::Horizontal);
  for (QTabBar* tabs : findChildren<QTabBar*>()) {
    tabs->setElideMode(Qt::ElideNone);
    tabs->setUsesScrollButtons(false);
  }
}

// What can be done next, in a sentence.
QString MainWindow::nextStep() const {
  if (marking_) return Words::tr("Click on the organ to mark a place; right drag turns the view.");
  if (attempt_ && attemptEnded_ && session_->showing())
    return Words::tr("The exercise is over: click a point in the list to see that moment again.");
  const ToolHandling& tools = session_->tools();
  if (session_->playing())
    return Words::tr("The scenario shows how; take an instrument to do it yourself.");
  if (session_->showing() && !timeline_->atEnd())
    return Words::tr("This is an earlier moment: work on from here, or press End to go back.");
  if (session_->playedOut() && tools.how() == ToolHandling::Hold::None)
    return (session_->state().bled > 0
                ? Words::tr("The scenario has ended: %1 ml of blood lost; bleeding now: %2 ml/min, "
                            "%3. ")
                      .arg(1e6 * session_->state().bled, 0, 'f', 0)
                      .arg(60e6 * session_->state().bleedingRate, 0, 'f', 0)
                      .arg(gradeText(session_->state().bleedingRate))
                : Words::tr("The scenario has ended. ")) +
           Words::tr("Take an instrument to go on, or drag the mark in the timeline to look back.");
  const QString name = heldName();
  QString howLongClosed;
  for (const HaemostasisWatch& watch : haemostasis_)
    if (watch.tool() == tools.held()) howLongClosed = watch.howLongClosed(session_->state());
  const std::string kind =
      tools.held() < 0 ? "" : session_->toolModels()[std::size_t(tools.held())].kind;
  const bool deep = kind != "inflow_clamp" && kind != "suction";  // its depth matters
  const QString depth =
      tools.how() == ToolHandling::Hold::Guided && deep
          ? ", " + (tools.surfaceHand() && tools.surfaceHand()->target
                        ? Words::tr("at the white ring")
                        : (tools.isLeastDeep(tools.held())
                               ? Words::tr("%1 mm deep, the least for cells of this size (wheel)")
                           : tools.isMostDeep(tools.held())
                               ? Words::tr("%1 mm deep, the most for this instrument (wheel)")
                               : Words::tr("%1 mm deep (wheel)"))
                              .arg(std::lround(1e3 * tools.depth(tools.held()))))
          : QString();
  const SurfaceHand* hand = tools.surfaceHand();
  const bool cuts = hand && hand->style.entersSlowly && hand->stroke >= kShortestTold;
  const QString length =
      cuts ? (tools.pressing() ? Words::tr(", %1 mm long") : Words::tr(", last stroke %1 mm long"))
                 .arg(std::lround(1e3 * hand->stroke))
           : QString();
  switch (tools.how()) {
    case ToolHandling::Hold::None:
      if (!attempt_ && hasMotions())
        return Words::tr(
            "Take an instrument: press its number, or click it in the list. P shows how the "
            "scenario does it, F1 all controls.");
      return Words::tr(
          "Take an instrument: press its number, or click it in the list. F1 shows all "
          "controls.");
    case ToolHandling::Hold::Direct:
      return Words::
          tr("%1: drag moves it, the wheel brings it nearer, Shift turns it; Escape puts it back.")
              .arg(name);
    case ToolHandling::Hold::Guided:
      if (tools.pressing())
        return Words::tr("%1 at work%2; F leaves it there.")
            .arg(name, depth + length + howLongClosed);
      return Words::tr("%1: %2%3.").arg(name, useOf(kind, session_->state()), depth + length);
    case ToolHandling::Hold::HandleBox:
      return Words::tr("%1 in a handle box: drag it to move it; middle click to turn it.")
          .arg(name);
    case ToolHandling::Hold::Trackball:
      return Words::tr("%1 in a trackball: drag it to turn it; middle click to move it.").arg(name);
  }
  return {};
}

void MainWindow::followPanels(const LiveState& state, qint64 now) {
  const int felt = session_->playing() ? playedTool(state) : workingTool(state);
  operation_->follow(state, felt);
  timeline_->follow(state, session_->showing(), session_->answered());
  const QString step = exercising() ? exercise_->nextStep() : QString();
  // An exercise's step comes first; how to use what is in hand follows, not that something should
  // be.
  const bool empty = session_->tools().how() == ToolHandling::Hold::None && !session_->showing();
  hint_->reserve(exercising() || afterExercise_ ? 3 : 2);
  hint_->say(loader_.busy() || operations_.busy()
                 ? Words::tr("One moment: an operation is being prepared. The one that is shown "
                             "ends as soon as it is ready.")
             : afterExercise_ ? Words::tr("The exercise is over: what is done now does not count") +
                                    ".   " + nextStep()
             : step.isEmpty() ? nextStep()
             : empty          ? step
                              : step + "   " + nextStep());
  // A slow second may have other causes, such as a program that starts.
  constexpr qint64 kLong = 2000;  // ms
  const double cell = session_->cells().lattice.spacing.x();
  const int wanted = smoothCells(state, session_->scenario().frameRate, cell);
  if (wanted == 0) slowSince_ = 0;
  if (wanted > 0 && slowSince_ == 0) slowSince_ = now;
  // Not in an exercise, whose cells are the same for everybody.
  const bool slow = slowSince_ > 0 && now - slowSince_ > kLong && !exercising();
  const int offered = slow ? wanted : 0;
  if (offered != hint_->offered() && (offered == 0 || hint_->offered() == 0)) {
    hint_->offerCells(offered);
    if (options_.reports && offered > 0) {
      const QPoint at = hint_->buttonPlace() * devicePixelRatioF();
      say("place smooth {} {}", at.x(), at.y());
      say("slow: cells of {} mm offered", offered);
    }
  }
  organ_->follow(state);
  if (options_.reports && organ_->waiting() != waitingSaid_) {
    waitingSaid_ = organ_->waiting();
    say("settings {}", waitingSaid_ ? "wait" : "are in force");
  }
  organ_->setIso(session_->iso().value());
  removed_->follow(state);
  force_->follow(state, felt);
  timing_->follow(state, viewer_->drawing(), session_->scenario().frameRate);
}

}  // namespace resect

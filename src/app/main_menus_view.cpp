// The menus of the views and of the scenarios.
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>

#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "inventor/hand/tool_keys.h"
#include "io/data_folder.h"
#include "io/scenario/scenario_file.h"

namespace resect {

void MainWindow::makeViewMenu() {
  QMenu* view = menuBar()->addMenu("&View");
  const std::pair<const char*, RoomView> views[] = {{"&Surgeon", RoomView::Surgeon},
                                                    {"&Assistant", RoomView::Assistant},
                                                    {"&Top", RoomView::Top},
                                                    {"&Laparoscope", RoomView::Laparoscope}};
  int number = 1;
  for (const auto& [name, which] : views)
    add(view, name, QKeySequence(QString("Ctrl+%1").arg(number++)), "Looks from there",
        [this, which = which] { look(which); });
  view->addSeparator();
  add(view, "&Home", QKeySequence("H"), "The surgeon's view, as at the start",
      [this] { look(RoomView::Surgeon); });
  add(view, "&View all", QKeySequence("A"), "Organ and instruments, from this side",
      [this] { viewAll(); });
  add(view, "Zoom &in", QKeySequence::ZoomIn,
      "Nearer to the middle of the picture; the wheel zooms to the pointer",
      [this] { zoom(0.88); });
  add(view, "Zoom &out", QKeySequence::ZoomOut, "Farther away", [this] { zoom(1 / 0.88); });
  add(view, "Look at a &point: click it", QKeySequence("L"),
      "The camera turns round the point that is clicked next", [this] {
        lookingAt_ = true;
        viewer_->setCursor(Qt::CrossCursor);
        statusBar()->showMessage("Click what you want to look at");
      });
  add(view, "&Bring back view and instruments", QKeySequence(Qt::Key_Space),
      "The view as at the start, and all instruments into the tray; the organ stays as it is",
      [this] { bringEverythingBack(); });
  view->addSeparator();
  addSoundItem(view, speaker_);
  laboratory_ = view->addAction("La&boratory");
  laboratory_->setShortcut(QKeySequence(Qt::Key_F2));
  laboratory_->setCheckable(true);
  laboratory_->setToolTip(
      "Cells, surface and timing: panels for those who develop, and the scale of the iso level");
  connect(laboratory_, &QAction::toggled, this, [this](bool on) { showLaboratory(on); });
  connect(laboratory_, &QAction::triggered, this, [this](bool on) { laboratoryChosen_ = on; });
  scale_ = view->addAction("S&cale of the iso level");
  scale_->setCheckable(true);
  scale_->setToolTip("Its arrow sets how much of each cell counts as tissue");
  connect(scale_, &QAction::toggled, this, [this](bool on) {
    if (session_) session_->showScale(on);
  });
  marks_ = view->addAction("Mark what b&leeds");
  marks_->setCheckable(true);
  marks_->setChecked(true);
  marks_->setToolTip(
      "While an instrument is in hand that stops bleeding: rings round the ends of vessels that "
      "bleed, to which it is guided");
  connect(marks_, &QAction::toggled, this, [this](bool on) {
    if (session_) session_->setBleedingMarks(on);
  });
  field_ = view->addAction("Op&ened abdomen");
  field_->setCheckable(true);
  field_->setToolTip("What stands round the organ: an opened abdomen, or the operating table");
  connect(field_, &QAction::triggered, this, [this](bool on) {
    if (!session_) return;
    session_->showField(on);
    if (options_.reports) say("setting {}", on ? "field" : "table");
  });
  breathing_ = view->addAction("B&reathing");
  breathing_->setCheckable(true);
  breathing_->setToolTip(
      "Whether the patient breathes; switched off, the breath is held when it has ended");
  connect(breathing_, &QAction::triggered, this, [this](bool on) {
    if (!session_) return;
    session_->operation().setBreathing(on);
    if (options_.reports) say("breathing {}", on ? "on" : "off");
  });
  connect(view, &QMenu::aboutToShow, this, [this] {
    breathing_->setEnabled(session_ && session_->state().canBreathe);
    breathing_->setChecked(session_ && session_->state().breathes);
  });
  thesis_ = view->addAction("Thesis &mode");
  thesis_->setCheckable(true);
  thesis_->setToolTip(
      "As the original system: still tissue, and each instrument takes out what it touches. The "
      "operation begins again");
  connect(thesis_, &QAction::triggered, this, [this](bool on) { switchThesis(on); });
  QMenu* panels = view->addMenu("&Panels");
  panels->setToolTipsVisible(true);
  for (QDockWidget* dock : findChildren<QDockWidget*>()) {
    dock->toggleViewAction()->setToolTip("Shows or hides this panel");
    panels->addAction(dock->toggleViewAction());
  }
  dark_ = view->addAction("&Dark");
  dark_->setToolTip("Dark colours; kept for the next start");
  dark_->setCheckable(true);
  add(view, "&Full screen", QKeySequence("F11"), "And back again",
      [this] { isFullScreen() ? showNormal() : showFullScreen(); });
}

void MainWindow::zoom(double factor) {
  if (!session_) return;
  session_->zoom(factor);
  if (options_.reports) reportPlaces();
}

// Begins the same scenario in thesis mode, or out of it.
void MainWindow::switchThesis(bool on) {
  if (!session_) return thesis_->setChecked(!on);
  Scenario scenario = session_->scenario();
  on ? makeThesis(scenario) : makeElastic(scenario);
  if (!load(scenario)) thesis_->setChecked(!on);
}

// Scenarios by their titles; those of the thesis apart.
void MainWindow::makeScenarioMenu(QMenu* file) {
  QMenu* scenarios = file->addMenu("S&cenario");
  QMenu* thesis = new QMenu("As in the &thesis", this);
  thesis->setToolTipsVisible(true);
  for (const std::string& name : shippedNames("scenarios", ".toml")) {
    const Scenario scenario = readScenario(dataFolder() / "scenarios" / (name + ".toml"));
    const bool old = scenario.mode == OperationMode::Thesis;
    add(old ? thesis : scenarios, shown(scenario.title.empty() ? name : scenario.title), {},
        "<p>" + shownInHtml(scenario.description) + "</p><p>" + shownInHtml(name) + "</p>",
        [this, name] {
          openFile(
              QString::fromStdString((dataFolder() / "scenarios" / (name + ".toml")).string()));
        });
  }
  scenarios->addSeparator();
  scenarios->addMenu(thesis);
}

// The first entries of the menu of instruments: those of the present operation.
void MainWindow::listInstruments() {
  for (QAction* action : instrumentActions_) delete action;
  instrumentActions_.clear();
  QAction* first = instrumentMenu_->actions().value(0);
  for (int i = 0; i < session_->tools().toolCount(); ++i) {
    const ToolModel& tool = session_->toolModels()[std::size_t(i)];
    auto* action = new QAction(
        QString("&%1  %2").arg(QString::fromStdString(keyOfTool(std::size_t(i))), shown(tool.name)),
        this);
    action->setToolTip("<p>" + shownInHtml(tool.description) + "</p>");
    connect(action, &QAction::triggered, this, [this, i] {
      if (session_) session_->tools().take(i);
    });
    instrumentMenu_->insertAction(first, action);
    instrumentActions_.push_back(action);
  }
}

}  // namespace resect

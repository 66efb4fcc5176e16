// The menus of the views and of the scenarios.
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>

#include "app/language/language_menu.h"
#include "app/language/words.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "inventor/hand/tool_keys.h"
#include "io/data_folder.h"
#include "io/scenario/scenario_file.h"

namespace resect {

void MainWindow::makeViewMenu() {
  QMenu* view = menuBar()->addMenu(Words::tr("&View"));
  const std::pair<const char*, RoomView> views[] = {
      {QT_TRANSLATE_NOOP("window", "&Surgeon"), RoomView::Surgeon},
      {QT_TRANSLATE_NOOP("window", "&Assistant"), RoomView::Assistant},
      {QT_TRANSLATE_NOOP("window", "&Top"), RoomView::Top},
      {QT_TRANSLATE_NOOP("window", "&Laparoscope"), RoomView::Laparoscope}};
  int number = 1;
  for (const auto& [name, which] : views)
    add(view, Words::tr(name), QKeySequence(QString("Ctrl+%1").arg(number++)),
        Words::tr("Looks from there"), [this, which = which] { look(which); });
  view->addSeparator();
  add(view, Words::tr("&Home"), QKeySequence("H"), Words::tr("The surgeon's view, as at the start"),
      [this] { look(RoomView::Surgeon); });
  add(view, Words::tr("&View all"), QKeySequence("A"),
      Words::tr("Organ and instruments, from this side"), [this] { viewAll(); });
  add(view, Words::tr("Zoom &in"), QKeySequence::ZoomIn,
      Words::tr("Nearer to the middle of the picture; the wheel zooms to the pointer"),
      [this] { zoom(0.88); });
  add(view, Words::tr("Zoom &out"), QKeySequence::ZoomOut, Words::tr("Farther away"),
      [this] { zoom(1 / 0.88); });
  add(view, Words::tr("Look at a &point: click it"), QKeySequence("L"),
      Words::tr("The camera turns round the point that is clicked next"), [this] {
        lookingAt_ = true;
        viewer_->setCursor(Qt::CrossCursor);
        statusBar()->showMessage(Words::tr("Click what you want to look at"));
      });
  add(view, Words::tr("&Bring back view and instruments"), QKeySequence(Qt::Key_Space),
      Words::tr(
          "The view as at the start, and all instruments into the tray; the organ stays as it is"),
      [this] { bringEverythingBack(); });
  view->addSeparator();
  addSoundItem(view, speaker_);
  laboratory_ = view->addAction(Words::tr("La&boratory"));
  laboratory_->setShortcut(QKeySequence(Qt::Key_F2));
  laboratory_->setCheckable(true);
  laboratory_->setToolTip(Words::tr(
      "Cells, surface and timing: panels for those who develop, and the scale of the iso level"));
  connect(laboratory_, &QAction::toggled, this, [this](bool on) { showLaboratory(on); });
  connect(laboratory_, &QAction::triggered, this, [this](bool on) { laboratoryChosen_ = on; });
  scale_ = view->addAction(Words::tr("S&cale of the iso level"));
  scale_->setCheckable(true);
  scale_->setToolTip(Words::tr("Its arrow sets how much of each cell counts as tissue"));
  connect(scale_, &QAction::toggled, this, [this](bool on) {
    if (session_) session_->showScale(on);
  });
  marks_ = view->addAction(Words::tr("Mark what b&leeds"));
  marks_->setCheckable(true);
  marks_->setChecked(true);
  marks_->setToolTip(Words::tr(
      "While an instrument is in hand that stops bleeding: rings round the ends of vessels that "
      "bleed, to which it is guided"));
  connect(marks_, &QAction::toggled, this, [this](bool on) {
    if (session_) session_->setBleedingMarks(on);
  });
  field_ = view->addAction(Words::tr("Op&ened abdomen"));
  field_->setCheckable(true);
  field_->setToolTip(
      Words::tr("What stands round the organ: an opened abdomen, or the operating table"));
  connect(field_, &QAction::triggered, this, [this](bool on) {
    if (!session_) return;
    session_->showField(on);
    if (options_.reports) say("setting {}", on ? "field" : "table");
  });
  hands_ = view->addAction(Words::tr("Surgeon's hands"));
  hands_->setCheckable(true);
  hands_->setToolTip(Words::tr(
      "Gloved hands hold the instruments in the opened abdomen; they hide what is below them"));
  connect(hands_, &QAction::toggled, this, [this](bool on) {
    if (session_) session_->showHands(on);
  });
  addLampMenu(view);
  breathing_ = view->addAction(Words::tr("B&reathing"));
  breathing_->setCheckable(true);
  breathing_->setToolTip(Words::tr(
      "Whether the patient breathes; switched off, the breath is held when it has ended"));
  connect(breathing_, &QAction::triggered, this, [this](bool on) {
    if (!session_) return;
    session_->operation().setBreathing(on);
    if (options_.reports) say("breathing {}", on ? "on" : "off");
  });
  connect(view, &QMenu::aboutToShow, this, [this] {
    breathing_->setEnabled(session_ && session_->state().canBreathe);
    breathing_->setChecked(session_ && session_->state().breathes);
  });
  thesis_ = view->addAction(Words::tr("Thesis &mode"));
  thesis_->setCheckable(true);
  thesis_->setToolTip(Words::tr(
      "As the original system: still tissue, and each instrument takes out what it touches. The "
      "operation begins again"));
  connect(thesis_, &QAction::triggered, this, [this](bool on) { switchThesis(on); });
  QMenu* panels = view->addMenu(Words::tr("&Panels"));
  panels->setToolTipsVisible(true);
  for (QDockWidget* dock : findChildren<QDockWidget*>()) {
    dock->toggleViewAction()->setToolTip(Words::tr("Shows or hides this panel"));
    panels->addAction(dock->toggleViewAction());
  }
  dark_ = view->addAction(Words::tr("&Dark"));
  dark_->setToolTip(Words::tr("Dark colours; kept for the next start"));
  dark_->setCheckable(true);
  addLanguageMenu(view,
                  [this](const QString& sentence) { statusBar()->showMessage(sentence, 8000); });
  add(view, Words::tr("&Full screen"), QKeySequence("F11"), Words::tr("And back again"),
      [this] { isFullScreen() ? showNormal() : showFullScreen(); });
}

void MainWindow::addLampMenu(QMenu* view) {
  QMenu* menu = view->addMenu(Words::tr("S&urgical lamp"));
  auto* group = new QActionGroup(menu);
  const std::pair<const char*, LampPlace> places[] = {
      {QT_TRANSLATE_NOOP("window", "At the patient's &right"), LampPlace::PatientsRight},
      {QT_TRANSLATE_NOOP("window", "At the patient's &left"), LampPlace::PatientsLeft},
      {QT_TRANSLATE_NOOP("window", "Over the &surgeon's shoulder"), LampPlace::Surgeon},
      {QT_TRANSLATE_NOOP("window", "Straight &above"), LampPlace::Above}};
  static constexpr const char* kept = "lamp";  // setting: the place's number
  const int before = QSettings().value(kept, 0).toInt();
  for (const auto& [name, place] : places) {
    if (int(place) == before) lampPlace_ = place;
    QAction* action = menu->addAction(Words::tr(name));
    action->setCheckable(true);
    action->setChecked(int(place) == before);
    action->setToolTip(
        Words::tr("Moves the main lamp there; in a laparoscope's view it does not shine"));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, place = place] {
      lampPlace_ = place;
      QSettings().setValue(kept, int(place));
      if (session_) session_->moveLamp(place);
      if (options_.reports) say("lamp {}", int(place));
    });
  }
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
  QMenu* scenarios = file->addMenu(Words::tr("S&cenario"));
  QMenu* thesis = new QMenu(Words::tr("As in the &thesis"), this);
  thesis->setToolTipsVisible(true);
  for (const std::string& name : shippedNames("scenarios", ".toml")) {
    const Scenario scenario = readScenario(dataFolder() / "scenarios" / (name + ".toml"));
    const bool old = scenario.mode == OperationMode::Thesis;
    add(old ? thesis : scenarios, translated(scenario.title.empty() ? name : scenario.title), {},
        "<p>" + translatedInHtml(scenario.description) + "</p><p>" + shownInHtml(name) + "</p>",
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
    auto* action =
        new QAction(QString("&%1  %2").arg(QString::fromStdString(keyOfTool(std::size_t(i))),
                                           translated(tool.name)),
                    this);
    action->setToolTip("<p>" + translatedInHtml(tool.description) + "</p>");
    connect(action, &QAction::triggered, this, [this, i] {
      if (session_) session_->tools().take(i);
    });
    instrumentMenu_->insertAction(first, action);
    instrumentActions_.push_back(action);
  }
}

}  // namespace resect

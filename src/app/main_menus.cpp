// The menus of the main window and their shortcuts.
#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QSettings>
#include <QStatusBar>

#include "app/exercise/exercises_page.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/controls_overlay.h"
#include "app/widgets/panels.h"
#include "base/error.h"
#include "io/data_folder.h"
#include "io/scenario/scenario_file.h"

namespace resect {

// An entry of a menu.
QAction* MainWindow::add(QMenu* menu, const QString& text, const QKeySequence& key,
                         const QString& tip, const std::function<void()>& act) {
  QAction* action = menu->addAction(text);
  action->setShortcut(key);
  action->setToolTip(tip);
  connect(action, &QAction::triggered, this, act);
  return action;
}

void MainWindow::makeMenus() {
  QMenu* file = menuBar()->addMenu("&File");
  add(file, "E&xercises ...", QKeySequence("Ctrl+T"),
      "Exercises with a goal and a result, and what this learner has reached",
      [this] { showExercises(); });
  add(file, "&Open organ, scene, scenario or operation ...", QKeySequence::Open,
      "A mesh, particles, a saved scene or a scenario; a file can also be dropped on the window",
      [this] {
        const QString name = QFileDialog::getOpenFileName(
            this, "Open", {},
            "All that can be opened (*.iv *.wrl *.obj *.stl *.ply *.off "
            "*.glb *.gltf *.3mf *.vtk *.dis *.resect-cells *.toml *.resect "
            "*.nii *.nrrd *.nhdr *.mha *.mhd *.dcm *.gz);;All files (*)");
        if (!name.isEmpty()) openFile(name);
      });
  add(file, "Open folder of &labels ...", {},
      "The labels of a scan with a file for each structure, as TotalSegmentator writes them",
      [this] {
        const QString name = QFileDialog::getExistingDirectory(this, "Open folder of labels");
        if (!name.isEmpty()) openFile(name);
      });
  for (const std::string_view organ : kBuiltInOrgans) {
    const std::string name(organ);
    add(file, QString::fromStdString("Built-in &" + name), {},
        QString::fromStdString("The " + name + " that comes with Resect, whole"), [this, name] {
          Scenario scenario = options_.scenario;
          keepFirstOrgan(scenario);
          OrganSource source = scenario.organs[0].source;
          source.file = name;
          if (source.file != scenario.organs[0].source.file) replaceOrgans(scenario, source);
          load(scenario);
        });
  }
  makeScenarioMenu(file);
  recent_ = file->addMenu("&Recent files");
  fillRecent();
  recordings_ = file->addMenu("Recorded op&erations");
  recordings_->setToolTip("What the window has recorded by itself; opened, an operation goes on");
  recordingOn_ = new QAction("&Record operations", this);
  recordingOn_->setCheckable(true);
  recordingOn_->setToolTip("Whether the next operations are recorded");
  recordingOn_->setChecked(QSettings().value("record", true).toBool());
  connect(recordingOn_, &QAction::toggled, this, [this](bool on) {
    QSettings().setValue("record", on);
    statusBar()->showMessage(on ? "From the next operation on, all is recorded"
                                : "From the next operation on, nothing is recorded",
                             8000);
  });
  connect(recordings_, &QMenu::aboutToShow, this, [this] { listRecordings(); });
  add(file, "Begin the operation &again", QKeySequence("Ctrl+N"),
      "The same organ, whole, with the settings of the laboratory's panel; the view stays, and "
      "what "
      "was done so far stays in its recording",
      [this] { organ_->beginAgain(); });
  file->addSeparator();
  add(file, "&Save operation", QKeySequence::Save,
      "All that was done, as one file: opened, the operation goes on where it was",
      [this] { saveOperation(false); });
  add(file, "Save operation &as ...", QKeySequence("Ctrl+Shift+S"), "The same under another name",
      [this] { saveOperation(true); });
  file->addSeparator();
  add(file, "Save s&urface ...", QKeySequence("Ctrl+E"), "The organ as it is now, as a closed mesh",
      [this] { saveSurface(); });
  add(file, "Save s&cene ...", QKeySequence("Ctrl+Shift+E"),
      "The whole room as an Inventor file, for this program and others", [this] { saveScene(); });
  add(file, "Save &picture ...", QKeySequence("Ctrl+P"),
      "The picture as it is seen, with smooth edges", [this] { savePicture(); });
  add(file, "Record a &film: start or stop", QKeySequence("Ctrl+R"),
      "A film of what is seen, until this is chosen again; needs ffmpeg",
      [this] { toggleVideo(); });
  file->addSeparator();
  add(file, "&Quit", QKeySequence("Ctrl+Q"), "Ends the operation", [this] { close(); });

  QMenu* edit = menuBar()->addMenu("&Edit");
  undo_ = add(edit, "&Undo stroke", QKeySequence::Undo,
              "Takes back the last stroke: from the first touch until the hand let go",
              [this] { undo(false); });
  redo_ = add(edit, "&Redo stroke", QKeySequence("Ctrl+Shift+Z"),
              "Does again the stroke that was taken back last", [this] { undo(true); });
  // Grey in the menu only: the keys of an action that is switched off would say nothing.
  connect(edit, &QMenu::aboutToShow, this, [this] {
    undo_->setEnabled(session_ && session_->state().undoable > 0);
    redo_->setEnabled(session_ && session_->state().redoable > 0);
  });
  connect(edit, &QMenu::aboutToHide, this, [this] {
    undo_->setEnabled(true);
    redo_->setEnabled(true);
  });

  makeTimelineMenu();

  makeViewMenu();

  QMenu* instruments = instrumentMenu_ = menuBar()->addMenu("&Instruments");
  instruments->addSeparator();
  const auto precise = [this](ToolHandling::Hold how) {
    if (session_ && session_->tools().held() >= 0)
      session_->tools().hold(session_->tools().held(), how);
  };
  add(instruments, "Along the &surface", QKeySequence("S"),
      "The instrument follows the organ's surface under the pointer", [=, this] {
        if (session_) precise(session_->tools().usual());
      });
  add(instruments, "&Direct", QKeySequence("D"), "Dragging moves it across the view",
      [=] { precise(ToolHandling::Hold::Direct); });
  add(instruments, "Handle &box: move", QKeySequence("B"), "Moves it along one axis or face",
      [=] { precise(ToolHandling::Hold::HandleBox); });
  add(instruments, "&Trackball: turn", QKeySequence("T"), "Turns it about its tip",
      [=] { precise(ToolHandling::Hold::Trackball); });
  add(instruments, "&Let go", QKeySequence("G"), "It stays where it is", [this] {
    if (session_) session_->tools().hold(-1, ToolHandling::Hold::None);
  });

  add(instruments, "L&eave at work", {},
      "While it presses: it goes on holding or pressing there, and the hand is free (key F)",
      [this] {
        if (session_ && session_->tools().pressing()) session_->tools().leave();
      });

  instruments->addSeparator();
  add(instruments, "&Play the scenario's motions", QKeySequence("P"),
      "Until they end, or an instrument is taken", [this] {
        if (!exercising()) return play(1e9);
        statusBar()->showMessage("In an exercise the ghost shows how it is done", 5000);
      });

  QMenu* help = menuBar()->addMenu("&Help");
  add(help, "&Controls", QKeySequence("F1"), "What mouse and keys do", [this] {
    if (overlay_->isVisible()) return overlay_->hide();
    overlay_->setGeometry(viewer_->rect());
    overlay_->show();
    overlay_->raise();
  });
  QAction* spaceMouse = help->addAction(QString());
  spaceMouse->setEnabled(false);
  connect(help, &QMenu::aboutToShow, this,
          [this, spaceMouse] { spaceMouse->setText(spaceMouse_.status()); });
  add(help, "&About", {}, "What this is", [this] {
    QMessageBox::about(this, "About Resect",
                       "<b>Resect</b><p>Virtual surgery on organ models, in real time.<p>"
                       "Not for diagnosis or treatment. Apache License 2.0.");
  });
  for (QMenu* menu : menuBar()->findChildren<QMenu*>()) menu->setToolTipsVisible(true);
}

// Keys go to the picture. Panels get them only if focused by Tab or by clicking into a number
// field; Escape returns the focus. Space in a number's field brings the view back; on a button
// focused by Tab it presses the button, as usual.
bool MainWindow::eventFilter(QObject* object, QEvent* event) {
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  // With an instrument in hand that has a pedal, P is the pedal.
  if (object == viewer_ && event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_P && session_ &&
      session_->tools().hasPedal()) {
    event->accept();
    return true;
  }
  const auto* widget = key ? qobject_cast<QWidget*>(object) : nullptr;
  if (!widget || widget == viewer_ || QApplication::activePopupWidget()) return false;
  if (exercises_->isAncestorOf(widget)) return false;
  if (widget->window() != this && !qobject_cast<QDockWidget*>(widget->window())) return false;
  const int code = static_cast<QKeyEvent*>(event)->key();
  if (code == Qt::Key_Escape && event->type() == QEvent::KeyPress) {
    activateWindow();
    viewer_->setFocus();
    return true;
  }
  if (code == Qt::Key_Space && event->type() == QEvent::ShortcutOverride) {
    event->setAccepted(qobject_cast<const QAbstractButton*>(widget) ||
                       qobject_cast<const QPlainTextEdit*>(widget) ||
                       (qobject_cast<const QLineEdit*>(widget) &&
                        !qobject_cast<const QAbstractSpinBox*>(widget->parentWidget())));
    return true;
  }
  return false;
}

void MainWindow::fillRecent() {
  recent_->clear();
  const QStringList files = QSettings().value("recent").toStringList();
  for (const QString& file : files)
    connect(recent_->addAction(shown(file.toStdString(), kLongestShownPath)), &QAction::triggered,
            this, [this, file] { openFile(file); });
  recent_->setEnabled(!files.isEmpty());
}

}  // namespace resect

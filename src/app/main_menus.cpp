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
#include "app/language/words.h"
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
  QMenu* file = menuBar()->addMenu(Words::tr("&File"));
  add(file, Words::tr("E&xercises ..."), QKeySequence("Ctrl+T"),
      Words::tr("Exercises with a goal and a result, and what this learner has reached"),
      [this] { showExercises(); });
  add(file, Words::tr("&Open organ, scene, scenario or operation ..."), QKeySequence::Open,
      Words::tr("A mesh, particles, a saved scene or a scenario; a file can also be dropped on the "
                "window"),
      [this] {
        const QString name = QFileDialog::getOpenFileName(
            this, Words::tr("Open"), {},
            Words::tr("All that can be opened (*.iv *.wrl *.obj *.stl *.ply *.off "
                      "*.glb *.gltf *.3mf *.vtk *.dis *.resect-cells *.toml *.resect "
                      "*.nii *.nrrd *.nhdr *.mha *.mhd *.dcm *.gz);;All files (*)"));
        if (!name.isEmpty()) openFile(name);
      });
  add(file, Words::tr("Open folder of &labels ..."), {},
      Words::tr(
          "The labels of a scan with a file for each structure, as TotalSegmentator writes them"),
      [this] {
        const QString name =
            QFileDialog::getExistingDirectory(this, Words::tr("Open folder of labels"));
        if (!name.isEmpty()) openFile(name);
      });
  for (const std::string_view organ : kBuiltInOrgans) {
    const std::string name(organ);
    add(file, Words::tr("Built-in &%1").arg(translated(name)), {},
        Words::tr("The %1 that comes with Resect, whole").arg(translated(name)), [this, name] {
          Scenario scenario = options_.scenario;
          keepFirstOrgan(scenario);
          OrganSource source = scenario.organs[0].source;
          source.file = name;
          if (source.file != scenario.organs[0].source.file) replaceOrgans(scenario, source);
          load(scenario);
        });
  }
  makeScenarioMenu(file);
  recent_ = file->addMenu(Words::tr("&Recent files"));
  fillRecent();
  recordings_ = file->addMenu(Words::tr("Recorded op&erations"));
  recordings_->setToolTip(
      Words::tr("What the window has recorded by itself; opened, an operation goes on"));
  recordingOn_ = new QAction(Words::tr("&Record operations"), this);
  recordingOn_->setCheckable(true);
  recordingOn_->setToolTip(Words::tr("Whether the next operations are recorded"));
  recordingOn_->setChecked(QSettings().value("record", true).toBool());
  connect(recordingOn_, &QAction::toggled, this, [this](bool on) {
    QSettings().setValue("record", on);
    statusBar()->showMessage(on ? Words::tr("From the next operation on, all is recorded")
                                : Words::tr("From the next operation on, nothing is recorded"),
                             8000);
  });
  connect(recordings_, &QMenu::aboutToShow, this, [this] { listRecordings(); });
  add(file, Words::tr("Begin the operation &again"), QKeySequence("Ctrl+N"),
      Words::tr(
          "The same organ, whole, with the settings of the laboratory's panel; the view stays, and "
          "what was done so far stays in its recording"),
      [this] { organ_->beginAgain(); });
  file->addSeparator();
  add(file, Words::tr("&Save operation"), QKeySequence::Save,
      Words::tr("All that was done, as one file: opened, the operation goes on where it was"),
      [this] { saveOperation(false); });
  add(file, Words::tr("Save operation &as ..."), QKeySequence("Ctrl+Shift+S"),
      Words::tr("The same under another name"), [this] { saveOperation(true); });
  file->addSeparator();
  add(file, Words::tr("Save s&urface ..."), QKeySequence("Ctrl+E"),
      Words::tr("The organ as it is now, as a closed mesh"), [this] { saveSurface(); });
  add(file, Words::tr("Save s&cene ..."), QKeySequence("Ctrl+Shift+E"),
      Words::tr("The whole room as an Inventor file, for this program and others"),
      [this] { saveScene(); });
  add(file, Words::tr("Save &picture ..."), QKeySequence("Ctrl+P"),
      Words::tr("The picture as it is seen, with smooth edges"), [this] { savePicture(); });
  add(file, Words::tr("Record a &film: start or stop"), QKeySequence("Ctrl+R"),
      Words::tr("A film of what is seen, until this is chosen again; needs ffmpeg"),
      [this] { toggleVideo(); });
  file->addSeparator();
  add(file, Words::tr("&Quit"), QKeySequence("Ctrl+Q"), Words::tr("Ends the operation"),
      [this] { close(); });

  QMenu* edit = menuBar()->addMenu(Words::tr("&Edit"));
  undo_ = add(edit, Words::tr("&Undo stroke"), QKeySequence::Undo,
              Words::tr("Takes back the last stroke: from the first touch until the hand let go"),
              [this] { undo(false); });
  redo_ = add(edit, Words::tr("&Redo stroke"), QKeySequence("Ctrl+Shift+Z"),
              Words::tr("Does again the stroke that was taken back last"), [this] { undo(true); });
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

  QMenu* instruments = instrumentMenu_ = menuBar()->addMenu(Words::tr("&Instruments"));
  instruments->addSeparator();
  const auto precise = [this](ToolHandling::Hold how) {
    if (session_ && session_->tools().held() >= 0)
      session_->tools().hold(session_->tools().held(), how);
  };
  add(instruments, Words::tr("Along the &surface"), QKeySequence("S"),
      Words::tr("The instrument follows the organ's surface under the pointer"), [=, this] {
        if (session_) precise(session_->tools().usual());
      });
  add(instruments, Words::tr("&Direct"), QKeySequence("D"),
      Words::tr("Dragging moves it across the view"), [=] { precise(ToolHandling::Hold::Direct); });
  add(instruments, Words::tr("Handle &box: move"), QKeySequence("B"),
      Words::tr("Moves it along one axis or face"),
      [=] { precise(ToolHandling::Hold::HandleBox); });
  add(instruments, Words::tr("&Trackball: turn"), QKeySequence("T"),
      Words::tr("Turns it about its tip"), [=] { precise(ToolHandling::Hold::Trackball); });
  add(instruments, Words::tr("&Let go"), QKeySequence("G"), Words::tr("It stays where it is"),
      [this] {
        if (session_) session_->tools().hold(-1, ToolHandling::Hold::None);
      });

  add(instruments, Words::tr("L&eave at work"), {},
      Words::tr(
          "While it presses: it goes on holding or pressing there, and the hand is free (key F)"),
      [this] {
        if (session_ && session_->tools().pressing()) session_->tools().leave();
      });

  instruments->addSeparator();
  add(instruments, Words::tr("&Play the scenario's motions"), QKeySequence("P"),
      Words::tr("Until they end, or an instrument is taken"), [this] {
        if (!exercising()) return play(1e9);
        statusBar()->showMessage(Words::tr("In an exercise the ghost shows how it is done"), 5000);
      });

  QMenu* help = menuBar()->addMenu(Words::tr("&Help"));
  add(help, Words::tr("&Controls"), QKeySequence("F1"), Words::tr("What mouse and keys do"),
      [this] {
        if (overlay_->isVisible()) return overlay_->hide();
        overlay_->setGeometry(viewer_->rect());
        overlay_->show();
        overlay_->raise();
      });
  QAction* spaceMouse = help->addAction(QString());
  spaceMouse->setEnabled(false);
  connect(help, &QMenu::aboutToShow, this,
          [this, spaceMouse] { spaceMouse->setText(Words::tr(spaceMouse_.status())); });
  add(help, Words::tr("&About"), {}, Words::tr("What this is"), [this] {
    QMessageBox::about(this, Words::tr("About Resect"),
                       Words::tr("<b>Resect</b><p>Virtual surgery on organ models, in real time.<p>"
                                 "Not for diagnosis or treatment. Apache License 2.0."));
  });
  for (QMenu* menu : menuBar()->findChildren<QMenu*>()) menu->setToolTipsVisible(true);
}

// Keys go to the picture. Panels get them only if focused by Tab or by clicking into a number
// field; Escape returns the focus. Space in a number's field brings the view back; on a button
// focused by Tab it presses the button, as usual.
bool MainWindow::eventFilter(QObject* object, QEvent* event) {
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  const auto* widget = key ? qobject_cast<QWidget*>(object) : nullptr;
  if (!widget || QApplication::activePopupWidget()) return false;
  if (exercises_->isVisible() && widget->window() == this)
    return keyOnExercises(static_cast<QKeyEvent*>(event), exercises_->isAncestorOf(widget));
  // With an instrument in hand that has a pedal, P is the pedal.
  if (object == viewer_ && event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_P && session_ &&
      session_->tools().hasPedal()) {
    event->accept();
    return true;
  }
  if (widget == viewer_) return false;
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

// The page of exercises hides the operation, so keys do not reach it; Escape leaves the page.
bool MainWindow::keyOnExercises(QKeyEvent* event, bool onPage) {
  if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier) || event->key() == Qt::Key_F11)
    return false;
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  if (event->key() == Qt::Key_Escape) hideExercises();
  return !onPage || event->key() == Qt::Key_Escape;
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

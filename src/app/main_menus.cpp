// The menus of the main window and their shortcuts.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QStatusBar>

#include "app/controls_overlay.h"
#include "app/main_window.h"
#include "app/viewer.h"
#include "base/error.h"
#include "io/data_folder.h"
#include "io/scenario_file.h"

namespace resect {

void MainWindow::makeMenus() {
  const auto add = [this](QMenu* menu, const char* text, const QKeySequence& key, auto&& act) {
    QAction* action = menu->addAction(text);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, act);
    return action;
  };

  QMenu* file = menuBar()->addMenu("&File");
  add(file, "&Open organ, scene or scenario ...", QKeySequence::Open, [this] {
    const QString name =
        QFileDialog::getOpenFileName(this, "Open", {},
                                     "All that can be opened (*.iv *.wrl *.obj *.stl *.ply *.off "
                                     "*.glb *.gltf *.vtk *.dis *.toml "
                                     "*.gz);;All files (*)");
    if (!name.isEmpty()) openFile(name);
  });
  add(file, "Built-in &liver", {}, [this] {
    Scenario scenario = options_.scenario;
    scenario.organ.file.clear();
    load(scenario);
  });
  QMenu* scenarios = file->addMenu("S&cenario");
  for (const std::string& name : shippedNames("scenarios", ".toml"))
    add(scenarios, name.c_str(), {}, [this, name] {
      openFile(QString::fromStdString((dataFolder() / "scenarios" / (name + ".toml")).string()));
    });
  recent_ = file->addMenu("&Recent files");
  fillRecent();
  file->addSeparator();
  add(file, "Save s&urface ...", QKeySequence("Ctrl+E"), [this] { saveSurface(); });
  add(file, "&Save scene ...", QKeySequence::Save, [this] { saveScene(); });
  add(file, "Save &picture ...", QKeySequence("Ctrl+P"), [this] { savePicture(); });
  add(file, "Record &video: start or stop", QKeySequence("Ctrl+R"), [this] { toggleVideo(); });
  file->addSeparator();
  add(file, "&Quit", QKeySequence("Ctrl+Q"), [this] { close(); });

  QMenu* view = menuBar()->addMenu("&View");
  const std::pair<const char*, RoomView> views[] = {{"&Surgeon", RoomView::Surgeon},
                                                    {"&Assistant", RoomView::Assistant},
                                                    {"&Top", RoomView::Top},
                                                    {"&Laparoscope", RoomView::Laparoscope}};
  int number = 1;
  for (const auto& [name, which] : views)
    add(view, name, QKeySequence(QString("Ctrl+%1").arg(number++)),
        [this, which = which] { look(which); });
  view->addSeparator();
  add(view, "&Home, all in view", QKeySequence("H"), [this] { look(RoomView::Surgeon); });
  add(view, "Look at a &point: click it", QKeySequence("L"), [this] {
    lookingAt_ = true;
    viewer_->setCursor(Qt::CrossCursor);
    statusBar()->showMessage("Click what you want to look at");
  });
  add(view, "&Bring everything back", QKeySequence(Qt::Key_Space),
      [this] { bringEverythingBack(); });
  view->addSeparator();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) view->addAction(dock->toggleViewAction());
  QAction* dark = view->addAction("&Dark");
  dark->setCheckable(true);
  dark->setChecked(options_.dark);
  connect(dark, &QAction::toggled, this, [this](bool on) { setTheme(on); });
  add(view, "&Full screen", QKeySequence("F11"),
      [this] { isFullScreen() ? showNormal() : showFullScreen(); });

  QMenu* instruments = menuBar()->addMenu("&Instruments");
  const auto precise = [this](ToolHandling::Hold how) {
    if (session_ && session_->tools().held() >= 0)
      session_->tools().hold(session_->tools().held(), how);
  };
  add(instruments, "&Direct", QKeySequence("D"), [=] { precise(ToolHandling::Hold::Direct); });
  add(instruments, "Handle &box: move", QKeySequence("B"),
      [=] { precise(ToolHandling::Hold::HandleBox); });
  add(instruments, "&Trackball: turn", QKeySequence("T"),
      [=] { precise(ToolHandling::Hold::Trackball); });
  add(instruments, "&Let go", QKeySequence("G"), [this] {
    if (session_) session_->tools().hold(-1, ToolHandling::Hold::None);
  });

  instruments->addSeparator();
  add(instruments, "&Play the scenario's motions", QKeySequence("P"), [this] { play(1e9); });

  QMenu* help = menuBar()->addMenu("&Help");
  add(help, "&Controls", QKeySequence("F1"), [this] {
    overlay_->setGeometry(viewer_->rect());
    overlay_->show();
    overlay_->raise();
  });
  QAction* spaceMouse = help->addAction(QString());
  spaceMouse->setEnabled(false);
  connect(help, &QMenu::aboutToShow, this,
          [this, spaceMouse] { spaceMouse->setText(spaceMouse_.status()); });
  add(help, "&About", {}, [this] {
    QMessageBox::about(this, "About Resect",
                       "<b>Resect</b><p>Virtual surgery on organ models, in real time.<p>"
                       "Not for diagnosis or treatment. Apache License 2.0.");
  });
}

// The keys belong to the picture. Panels get them only where somebody went on purpose, by Tab or
// into a field of numbers; Escape leads back from there, and Space is heard in fields too: it
// brings everything back. On a button that Tab led to it presses the button, as everywhere.
bool MainWindow::eventFilter(QObject* object, QEvent* event) {
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  const auto* widget = key ? qobject_cast<QWidget*>(object) : nullptr;
  if (!widget || widget == viewer_ || QApplication::activePopupWidget()) return false;
  if (widget->window() != this && !qobject_cast<QDockWidget*>(widget->window())) return false;
  const int code = static_cast<QKeyEvent*>(event)->key();
  if (code == Qt::Key_Escape && event->type() == QEvent::KeyPress) {
    activateWindow();
    viewer_->setFocus();
    return true;
  }
  if (code == Qt::Key_Space && event->type() == QEvent::ShortcutOverride) {
    event->setAccepted(qobject_cast<const QAbstractButton*>(widget) != nullptr);
    return true;
  }
  return false;
}

void MainWindow::fillRecent() {
  recent_->clear();
  const QStringList files = QSettings().value("recent").toStringList();
  for (const QString& file : files)
    connect(recent_->addAction(file), &QAction::triggered, this, [this, file] { openFile(file); });
  recent_->setEnabled(!files.isEmpty());
}

}  // namespace resect

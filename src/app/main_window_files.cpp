// Opening and saving of files in the main window: menus, drops and scripts.
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <filesystem>

#include "app/language/words.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/open_organ_dialog.h"
#include "app/widgets/parts_table.h"
#include "base/error.h"
#include "formats/beside_files.h"
#include "formats/png_file.h"
#include "inventor/scene/scene_file.h"
#include "io/cells/particle_file.h"
#include "io/mesh_file.h"
#include "io/output/run_files.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/scenario_files.h"

namespace resect {

void MainWindow::checkWritten(const std::string& file) const {
  std::vector<std::filesystem::path> inputs = filesRead(session_->scenario());
  addFilesBeside(inputs);
  checkOutputs({{{"the window", file}}}, inputs);
}

void MainWindow::writeScene(const std::string& file) {
  writeSceneFile(file, session_->room(), session_->operation().surface());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  // Queried again: the source may have closed or be too slow.
  const auto urls = event->mimeData()->urls();
  if (urls.isEmpty() || !urls.front().isLocalFile())
    return complain("what was dropped did not arrive; drop it again, or open it by the File menu");
  event->acceptProposedAction();
  openFile(urls.front().toLocalFile());
}

// Organ, scenario or saved scene, recognised by content.
void MainWindow::openFile(const QString& file) {
  try {
    const std::filesystem::path path = file.toStdString();
    if (path.extension() == ".resect") {
      openOperation(file);
    } else if (path.extension() == ".toml") {
      const Scenario scenario = readScenario(path);
      for (const ScenarioOrgan& organ : scenario.organs) requireOrganThere(organ.source);
      load(scenario);
      remember(file);
    } else if (isParticleFile(path)) {
      Scenario scenario = options_.scenario;
      OrganSource source;
      source.file = path.string();
      replaceOrgans(scenario, source);
      load(scenario);
      remember(file);
    } else {
      askOrgan(file);
    }
  } catch (const std::exception& e) {
    complain(e.what());
  }
}

void MainWindow::askOrgan(const QString& file) {
  auto* dialog = new OpenOrganDialog(file.toStdString(), options_.scenario.organs[0].source, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, file] {
    Scenario scenario = session_ ? session_->scenario() : options_.scenario;
    try {
      replaceOrgans(scenario, dialog->source());
    } catch (const std::exception& e) {
      return complain(e.what());
    }
    // A saved scene keeps its position.
    if (scenario.organs[0].source.part == kOrganNode) scenario.organs[0].source.onTable = false;
    load(scenario);
    remember(file);
  });
  dialog->examined = [this, dialog](const std::string& report) {
    if (!options_.reports) return;
    const QPoint at = dialog->openButton() * devicePixelRatioF();
    say("place open {} {}", at.x(), at.y());
    for (int row = 0; dialog->roles() && row < dialog->roles()->rowCount(); ++row) {
      const QPoint role = dialog->roles()->rolePlace(row) * devicePixelRatioF();
      say("place role{} {} {}", row, role.x(), role.y());
    }
    say("report {}", report);
  };
  dialog->surfaceShown = [this] {
    if (options_.reports) say("surface turns");
  };
  dialog->open();
}

void MainWindow::remember(const QString& file) {
  QSettings settings;
  QStringList recent = settings.value("recent").toStringList();
  recent.removeAll(file);
  recent.prepend(file);
  settings.setValue("recent", QStringList(recent.mid(0, 8)));
  fillRecent();
}

void MainWindow::save(const QString& title, const QString& filter, const QString& name,
                      const std::function<void(const std::string&)>& write) {
  if (!session_) return;
  const QString file = QFileDialog::getSaveFileName(this, title, name, filter);
  if (file.isEmpty()) return;
  try {
    checkWritten(file.toStdString());
    write(file.toStdString());
    statusBar()->showMessage(Words::tr("Written: %1").arg(shown(file.toStdString())), 5000);
    if (options_.reports) say("written {}", file.toStdString());
  } catch (const std::exception& e) {
    complain(e.what());
  }
}

void MainWindow::saveSurface() {
  save(Words::tr("Save surface"), Words::tr("Meshes (*.stl *.obj *.ply *.vtk *.iv)"), "organ.stl",
       [this](const std::string& file) {
         writeMeshFile(file, session_->operation().surface().mesh);
       });
}

void MainWindow::saveScene() {
  save(Words::tr("Save scene"), Words::tr("Open Inventor (*.iv)"), "scene.iv",
       [this](const std::string& file) { writeScene(file); });
}

void MainWindow::savePicture() {
  save(Words::tr("Save picture"), Words::tr("PNG (*.png)"), "picture.png",
       [this](const std::string& file) { writePng(file, viewer_->grabPicture(true)); });
}

}  // namespace resect

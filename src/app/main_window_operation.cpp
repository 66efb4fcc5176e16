// Operations in the main window: begun, opened, saved and given up.
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <QApplication>
#include <QDateTime>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/exercise/exercises_page.h"
#include "app/language/words.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/banner.h"
#include "app/widgets/controls_overlay.h"
#include "app/widgets/instruments_panel.h"
#include "app/widgets/operation_panel.h"
#include "app/widgets/panels.h"
#include "app/widgets/timeline_panel.h"
#include "base/error.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operating_room.h"
#include "inventor/scene/scene_file.h"
#include "record/session_recordings.h"

namespace resect {
namespace {

// In the window's settings: what its recordings hold.
constexpr const char* kNotes = "recordings";

// "2026-11-26 14:03" of a recording that the window has named by date, time and scenario; else its
// name.
QString whenOf(const QString& name) {
  const QDateTime when = QDateTime::fromString(name.left(19), "yyyy-MM-dd_HH-mm-ss");
  return when.isValid() ? when.toString("yyyy-MM-dd HH:mm") : name;
}

}  // namespace

// what: what is being prepared; said in place of the first picture too.
void MainWindow::showProgress(double share, const QString& what) {
  statusBar()->showMessage(what);
  if (options_.reports && !session_ && share < 0) say("waiting for {}", what.toStdString());
  viewer_->sayWaiting(share < 0 ? what
                                : QString("%1 %2 %").arg(what).arg(std::lround(100 * share)));
  progress_->setRange(0, share < 0 ? 0 : 1000);
  progress_->setValue(int(1000 * share));
  progress_->show();
  cancel_->show();
}

bool MainWindow::load(const Scenario& scenario) {
  if (!mayEnd()) return false;
  operations_.cancel();
  keepsView_ = false;
  if (session_) complaint_->hide();
  const QString what = Words::tr("Preparing: %1").arg(namesOf(scenario.organs));
  showProgress(-1, what);
  loader_.load(
      asExercise(scenario), [this, what](double share) { showProgress(share, what); },
      [this](OrganLoader::Result result) { begin(std::move(result)); });
  return true;
}

void MainWindow::openOperation(const QString& file, bool anew) {
  if (!mayEnd()) return;
  loader_.cancel();
  keepsView_ = anew;
  if (session_) complaint_->hide();
  const QString what =
      anew ? Words::tr("Beginning again ...") : Words::tr("Opening the operation ...");
  showProgress(-1, what);
  operations_.load(
      {file.toStdString(), anew, QSettings().value("record", true).toBool(),
       std::size_t(options_.historyMemory) << 20},
      [this, what](double share) { showProgress(share, what); },
      [this, file, anew](OrganLoader::Result result) {
        const std::filesystem::path path = file.toStdString();
        if (!begin(std::move(result))) {
          if (!session_ && !loader_.busy()) loadDefault();
          return;
        }
        if (anew) return;  // another operation, which has no name yet
        // A recording of the window's own has no name that a person gave it.
        if (path.parent_path() != recordingsFolder()) {
          operationFile_ = path.string();
          remember(file);
        }
        setWindowTitle("Resect - " + shown(path.filename().string()));
      });
}

void MainWindow::cancelLoading() {
  loader_.cancel();
  operations_.cancel();
  progress_->hide();
  cancel_->hide();
  if (session_) {
    statusBar()->showMessage(Words::tr("Cancelled; nothing has changed"), 4000);
  } else {
    loadDefault();
  }
}

// Loads the built-in liver at the start, coarse enough to appear at once.
void MainWindow::loadDefault() {
  Scenario scenario = options_.scenario;
  OrganSource liver;
  liver.spacing = 0.008;
  replaceOrgans(scenario, liver);
  load(scenario);
}

// Loads what can be had of a scenario that could not be loaded at the start: its organ without its
// ligaments, which may have been meant for another organ; if that was tried, the built-in liver.
void MainWindow::loadInstead(Scenario scenario) {
  bool held = false;
  for (ScenarioOrgan& organ : scenario.organs) {
    held = held || !organ.tissue.attachments.empty();
    organ.tissue.attachments.clear();
  }
  if (held)
    load(scenario);
  else if (scenario.organs.size() > 1 || scenario.organs[0].source.file != "liver")
    loadDefault();
}

bool MainWindow::begin(OrganLoader::Result result) {
  progress_->hide();
  cancel_->hide();
  statusBar()->clearMessage();
  if (!result.simulation) {
    complain(result.problem);
    if (!session_) loadInstead(std::move(result.scenario));
    return false;
  }
  try {
    std::optional<ScenePlaces> places;
    if (result.scenario.organs[0].source.part == kOrganNode && result.recording.empty())
      places = readModel(result.scenario.organs[0].source.file).places;
    std::shared_ptr<Recorder> recorder = result.history ? result.recorder : record(result);
    const bool goesOn = result.history.has_value();
    std::size_t strokes = 0;
    for (std::size_t b = 0; goesOn && b < result.history->courses().size(); ++b)
      strokes += result.history->courses()[b].strokes.strokes().size();
    OperationWatch watch = recorder ? watchOf(recorder) : OperationWatch();
    std::shared_ptr<LiveAttempt> attempt;
    if (result.scenario.task && !goesOn) {
      attempt = std::make_shared<LiveAttempt>(result.scenario, *result.simulation);
      watch = attempt->watch(std::move(watch));
    }
    // An exercise's time begins with the first instrument that is taken.
    const bool waits = attempt != nullptr;
    auto session = std::make_unique<OperatingSession>(result.scenario, std::move(result.simulation),
                                                      viewer_->aspect(), std::move(watch),
                                                      std::move(result.history), waits);
    // The thesis's way of working has the laboratory, unless the user has chosen.
    session->setBleedingMarks(marks_->isChecked());
    session->showScale(laboratoryChosen_.value_or(result.scenario.mode == OperationMode::Thesis));
    session->moveLamp(lampPlace_);
    if (options_.reports) say("lamp {}", int(lampPlace_));
    session->look(roomView(session->scenario().view).value_or(RoomView::Surgeon),
                  viewer_->aspect());
    if (places) {
      const int tools = std::min(int(places->tools.size()), session->tools().toolCount());
      for (int i = 0; i < tools; ++i) session->tools().setPose(i, places->tools[std::size_t(i)]);
      setCamera(session->room(), *places);
    }
    if (keepsView_ && session_) {
      session->room().camera()->copyFieldValues(session_->room().camera());
      statusBar()->showMessage(
          recorder_
              ? Words::tr("Begun again; what was done before is in File > Recorded operations")
              : Words::tr("Begun again"),
          6000);
    }
    viewer_->show(nullptr);
    noteRecording();  // of the operation that ends here
    session_ = std::move(session);
    attempt_ = std::move(attempt);
    session_->operation().setHistoryMemory(std::size_t(options_.historyMemory) << 20);
    recorder_ = std::move(recorder);
    madeFrom_ = result.recording;
    strokesBefore_ = strokes;
    strokesNoted_.reset();
    operationFile_.clear();
    const std::string& title = result.scenario.title;
    setWindowTitle(title.empty() ? QString("Resect") : "Resect - " + translated(title));
  } catch (const std::exception& e) {
    complain(e.what());
    return false;
  }
  viewer_->show(session_.get());
  overlay_->guided = session_->tools().usual() == ToolHandling::Hold::Guided;
  overlay_->update();
  heldSaid_ = -2;
  haemostasis_.clear();
  clampSaid_ = false;
  haemorrhage_ = 1;
  for (std::size_t i = 0; i < session_->toolModels().size(); ++i)
    if (const ToolModel& tool = session_->toolModels()[i]; HaemostasisWatch::watches(tool))
      haemostasis_.emplace_back(int(i), tool);
  leftSaid_.assign(session_->toolModels().size(), 0);
  leftTools_.assign(session_->toolModels().size(), LeftTool::No);
  removedSaid_ = 0;
  uploadedSaid_ = 0;
  removed_->clear();
  instruments_->setTools(session_->toolModels());
  listInstruments();
  notRecorded_->setVisible(!recorder_);
  std::vector<QString> tools;
  for (const ToolModel& tool : session_->toolModels()) tools.push_back(translated(tool.name));
  timeline_->begin(tools, session_->scenario().frameRate);
  force_->begin(tools);
  QString notes;
  for (const std::string& note : result.notes) {
    const QString text = translated(note, kLongestSentence);
    const bool file = text.section(' ', 0, 0).contains('.');  // its name stays as it is
    notes +=
        (file ? text : text.left(1).toUpper() + text.mid(1)) + (text.endsWith('.') ? "\n" : ".\n");
  }
  operation_->begin(session_->scenario(), notes.trimmed(), tools);
  beginExercise();
  const bool thesis = session_->scenario().mode == OperationMode::Thesis;
  thesis_->setChecked(thesis);
  field_->setChecked(showsField(session_->scenario()));
  field_->setEnabled(!thesis);
  hands_->setEnabled(!thesis);
  session_->showHands(hands_->isChecked());
  laboratory_->setChecked(laboratoryChosen_.value_or(thesis));
  QTimer::singleShot(0, this, [this] { arrangePanels(); });
  const ScenarioOrgan& organ = session_->scenario().organs[0];
  organ_->setOrgans(session_->scenario().organs, session_->cells().lattice.spacing.x(),
                    notes.trimmed());
  organ_->setIso(session_->iso().value());
  if (!exercises_->isVisible()) viewer_->setFocus();  // a name may be typed there
  if (options_.reports)
    say("organ {}", std::filesystem::path(organ.source.file).filename().string());
  return true;
}

// A recorder of the coming operation; null if none is wanted, or none can be made, which is said.
std::shared_ptr<Recorder> MainWindow::record(const OrganLoader::Result& result) {
  // An exercise is scored from its recording.
  if (!result.scenario.task && !QSettings().value("record", true).toBool()) return nullptr;
  try {
    return recordSession(result.scenario, *result.simulation);
  } catch (const std::exception& e) {
    complain(e.what());
    return nullptr;
  }
}

bool MainWindow::mayEnd() {
  if (!session_ || (recorder_ && recorder_->failure().empty())) return true;
  const std::shared_ptr<const Timeline> timeline = session_->state().timeline;
  const bool done = timeline && timeline->strokeCount() > strokesBefore_;
  return !done ||
         QMessageBox::question(
             this, "Resect",
             Words::tr("This operation is not recorded: what was done will be lost. Leave it?"),
             QMessageBox::Discard | QMessageBox::Cancel,
             QMessageBox::Cancel) == QMessageBox::Discard;
}

// All that was done, into a recording with a name.
void MainWindow::writeOperation(const std::string& file) {
  if (!recorder_)
    throw error(
        "This operation is not being recorded and cannot be saved. Switch recording on in File > "
        "Recorded operations, then begin again.");
  checkWritten(file);
  // While somebody operates, frames are recorded that the window has not seen yet.
  Moment moment = session_->state().moment;
  if (!session_->state().showing) moment.frame = kEndOfBranch;
  QApplication::setOverrideCursor(Qt::WaitCursor);
  try {
    recorder_->saveAs(file, moment);
  } catch (...) {
    QApplication::restoreOverrideCursor();
    throw;
  }
  QApplication::restoreOverrideCursor();
  operationFile_ = file;
  setWindowTitle("Resect - " + shown(std::filesystem::path(file).filename().string()));
  remember(QString::fromStdString(file));
  statusBar()->showMessage(Words::tr("Saved: %1").arg(shown(file, kLongestShownPath)), 5000);
  if (options_.reports) say("written {}", file);
}

void MainWindow::saveOperation(bool elsewhere) {
  if (!session_) return;
  std::string file = operationFile_;
  if (recorder_ && (file.empty() || elsewhere)) {
    QString chosen = QFileDialog::getSaveFileName(
        this, Words::tr("Save operation"),
        file.empty() ? "operation.resect" : QString::fromStdString(file),
        Words::tr("Operations (*.resect)"));
    if (chosen.isEmpty()) return;
    if (!chosen.contains('.')) chosen += ".resect";
    file = chosen.toStdString();
  }
  try {
    writeOperation(file);
  } catch (const std::exception& e) {
    complain(e.what());
  }
}

// Keeps in the settings what the menu says of the recording. To read it from the file would take
// the sandbox, and all of the file.
void MainWindow::noteRecording() {
  if (!recorder_ || !session_ || !session_->state().timeline) return;
  const Timeline& timeline = *session_->state().timeline;
  const std::size_t strokes = timeline.strokeCount();
  strokesNoted_ = strokes;
  const Scenario& scenario = session_->scenario();
  std::int64_t end = 0;
  for (const Timeline::Course& course : timeline.courses) end = std::max(end, course.end);
  QSettings settings;
  settings.beginGroup(kNotes);
  settings.setValue(
      QString::fromStdString(recorder_->path().stem().string()),
      (strokes == 1 ? Words::tr("%1, %2, %3 stroke") : Words::tr("%1, %2, %3 strokes"))
          .arg(scenario.title.empty() ? namesOf(scenario.organs) : translated(scenario.title))
          .arg(clockText(double(end) / scenario.frameRate))
          .arg(strokes));
}

// The menu of what the window has recorded by itself.
void MainWindow::listRecordings() {
  recordings_->clear();
  noteRecording();
  QSettings settings;
  settings.beginGroup(kNotes);
  QStringList gone = settings.childKeys();
  std::uintmax_t sum = 0;
  const auto megabytes = [](std::uintmax_t bytes) {
    return QString("%1 MB").arg(double(bytes) / 1e6, 0, 'f', 1);
  };
  for (const SessionRecording& recording : sessionRecordings()) {
    sum += recording.bytes;
    const bool present = recorder_ && recording.path == recorder_->path();
    const QString name = QString::fromStdString(recording.path.stem().string());
    gone.removeAll(name);
    QString text = shown(whenOf(name).toStdString()) + "   ";
    if (const QString note = settings.value(name).toString(); !note.isEmpty()) text += note + ", ";
    text += megabytes(recording.bytes);
    text.replace('&', "&&");
    QAction* action =
        recordings_->addAction(present ? Words::tr("%1  (this one)").arg(text) : text);
    action->setToolTip("<p>" + shownInHtml(recording.path.string()) + "</p>");
    action->setEnabled(!present);
    connect(action, &QAction::triggered, this, [this, path = recording.path] {
      openOperation(QString::fromStdString(path.string()));
    });
  }
  for (const QString& name : gone) settings.remove(name);
  recordings_->addSeparator();
  QAction* all = recordings_->addAction(
      Words::tr("The last %1 are kept; together %2").arg(kKeptRecordings).arg(megabytes(sum)));
  all->setEnabled(false);
  recordings_->addAction(recordingOn_);
}

}  // namespace resect

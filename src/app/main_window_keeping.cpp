// Undo, films of the picture, and closing.
#include <QCloseEvent>
#include <QDateTime>
#include <QFileDialog>
#include <QLabel>
#include <QStatusBar>

#include "app/language/words.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"

namespace resect {

void MainWindow::toggleVideo() {
  if (video_) {
    try {
      video_->finish();
      statusBar()->showMessage(Words::tr("The video is written"), 5000);
      if (options_.reports) say("filmed");
    } catch (const std::exception& e) {
      complain(e.what());
    }
    video_.reset();
    recording_->hide();
    return;
  }
  if (!session_) return;
  if (!haveFfmpeg())
    return complain(
        "A film needs the program ffmpeg, which is not installed: install the package ffmpeg, then "
        "press Ctrl+R again. Ctrl+P saves a single picture, `resect run --frames` writes many.");
  const QString file = QFileDialog::getSaveFileName(this, Words::tr("Record film"), "operation.mp4",
                                                    Words::tr("MPEG-4 (*.mp4)"));
  if (file.isEmpty()) return;
  try {
    checkWritten(file.toStdString());
    const RgbImage picture = viewer_->grabPicture(false);
    videoSize_ = {picture.width, picture.height};
    video_ = std::make_unique<VideoWriter>(file.toStdString(), picture.width, picture.height,
                                           kVideoRate);
    pictureTaken_ = QDateTime::currentMSecsSinceEpoch();
    recording_->show();
    statusBar()->showMessage(
        Words::tr("Recording %1; Ctrl+R ends it").arg(shown(file.toStdString())), 5000);
  } catch (const std::exception& e) {
    complain(e.what());
  }
}

// A film records the displayed pictures in real time; a picture that stays is repeated. Rendering
// extra pictures for it would slow the operation down.
void MainWindow::film(qint64 now) {
  constexpr auto kInterval = qint64(1000 / kVideoRate);
  if (!video_ || now - pictureTaken_ < kInterval) return;
  try {
    const RgbImage picture = viewer_->grabPicture(false);
    if (QSize(picture.width, picture.height) != videoSize_) {
      toggleVideo();
      return complain("The video ends here: the picture has another size now.");
    }
    for (; now - pictureTaken_ >= kInterval; pictureTaken_ += kInterval) video_->add(picture);
  } catch (const std::exception& e) {
    video_.reset();
    recording_->hide();
    complain(e.what());
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayEnd()) return event->ignore();
  noteRecording();
  if (video_) toggleVideo();  // finishes the film
  QMainWindow::closeEvent(event);
}

// Takes the last stroke back, or does it again.
void MainWindow::undo(bool again) {
  if (!session_ || refusesGoingBack()) return;
  const LiveState& state = session_->state();
  const int strokes = again ? state.redoable : state.undoable;
  if (strokes == 0) {
    statusBar()->showMessage(again ? Words::tr("Nothing was taken back that could be done again")
                                   : Words::tr("There is no stroke to take back"),
                             4000);
    if (options_.reports) say("nothing to {}", again ? "redo" : "undo");
    return;
  }
  const int number = again ? state.undoable + 1 : state.undoable;
  statusBar()->showMessage(
      (again ? Words::tr("Stroke %1 is done again") : Words::tr("Stroke %1 is taken back"))
          .arg(number),
      4000);
  again ? session_->redo() : session_->undo();
  if (options_.reports) say("{}", again ? "redo" : "undo");
}

}  // namespace resect

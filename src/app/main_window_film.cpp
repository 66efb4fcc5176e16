// Recording of the window's picture as a film.
#include <QCloseEvent>
#include <QDateTime>
#include <QFileDialog>
#include <QLabel>
#include <QStatusBar>

#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"

namespace resect {

void MainWindow::toggleVideo() {
  if (video_) {
    try {
      video_->finish();
      statusBar()->showMessage("The video is written", 5000);
      if (options_.reports) say("filmed");
    } catch (const std::exception& e) {
      complain(e.what());
    }
    video_.reset();
    recording_->hide();
    return;
  }
  if (!session_) return;
  const QString file =
      QFileDialog::getSaveFileName(this, "Record video", "operation.mp4", "MPEG-4 (*.mp4)");
  if (file.isEmpty()) return;
  try {
    const RgbImage picture = viewer_->grabPicture(false);
    videoSize_ = {picture.width, picture.height};
    video_ = std::make_unique<VideoWriter>(file.toStdString(), picture.width, picture.height,
                                           kVideoRate);
    pictureTaken_ = QDateTime::currentMSecsSinceEpoch();
    recording_->show();
    statusBar()->showMessage("Recording " + file + "; Ctrl+R ends it", 5000);
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

// Finishes a film in progress.
void MainWindow::closeEvent(QCloseEvent* event) {
  if (video_) toggleVideo();
  QMainWindow::closeEvent(event);
}

}  // namespace resect

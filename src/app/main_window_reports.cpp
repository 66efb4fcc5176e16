// Reports of the main window to scripts, and their commands.
#include <Inventor/SbViewportRegion.h>
#include <unistd.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QSocketNotifier>
#include <QTabBar>
#include <sstream>

#include "app/exercise/exercise_panel.h"
#include "app/exercise/task_maker_panel.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/timeline_panel.h"
#include "formats/png_file.h"
#include "inventor/gl/SoOrganShape.h"
#include "io/mesh_file.h"

namespace resect {

// Commands of scripts, which bypass the file dialogs: "open FILE", "save-scene FILE", "save-surface
// FILE", "save-picture FILE", "save-operation FILE"; the picture's size: "picture-size WIDTH
// HEIGHT"; and where things are: "places".
void MainWindow::listenToScript() {
  auto* lines = new QSocketNotifier(0, QSocketNotifier::Read, this);
  connect(lines, &QSocketNotifier::activated, this, [this, lines] {
    char block[4096];
    const auto got = ::read(0, block, sizeof block);
    if (got <= 0) return lines->setEnabled(false);
    script_.append(block, std::size_t(got));
    for (std::size_t end; (end = script_.find('\n')) != std::string::npos;) {
      const std::string line = script_.substr(0, end);
      script_.erase(0, end + 1);
      const std::size_t space = line.find(' ');
      const std::string what = line.substr(0, space),
                        file = space == std::string::npos ? "" : line.substr(space + 1);
      try {
        if (what == "open") openFile(QString::fromStdString(file));
        if (what == "save-operation") {
          writeOperation(file);
          continue;
        }
        if (what.starts_with("save")) checkWritten(file);
        if (what == "save-scene") writeScene(file);
        if (what == "save-surface") writeMeshFile(file, session_->operation().surface().mesh);
        if (what == "save-picture") writePng(file, viewer_->grabPicture(true));
        if (what.starts_with("save")) say("written {}", file);
        if (what == "picture-size") resizePicture(file);
        if (what == "places" && session_) reportPlaces();
        if (what == "time" && session_) say("time {:.3f}", session_->state().time);
        if (what == "play") play(file.empty() ? 1e9 : std::stod(file));
      } catch (const std::exception& e) {
        complain(e.what());
      }
    }
  });
}

// Resizes the window for a picture of this size.
void MainWindow::resizePicture(const std::string& text) {
  std::istringstream in(text);
  int width = 0, height = 0;
  if (!(in >> width >> height) || width < 320 || height < 240)
    return complain("picture-size takes a width from 320 and a height from 240 on");
  resize(size() - viewer_->size() + QSize(width, height));
}

// Reports positions of objects in screen pixels.
void MainWindow::reportPlaces() {
  const SbViewportRegion viewport = viewer_->viewport();
  const double ratio = viewer_->devicePixelRatioF();
  const auto place = [&](const std::string& what, const Vec3& point) {
    const SbVec2s pixel = session_->pixelOf(point, viewport);
    const QPoint local(int(pixel[0] / ratio), viewer_->height() - 1 - int(pixel[1] / ratio));
    const QPoint global = viewer_->mapToGlobal(local);
    say("place {} {} {}", what, int(global.x() * ratio), int(global.y() * ratio));
  };
  for (int i = 0; i < session_->tools().toolCount(); ++i)
    place(session_->toolModels()[std::size_t(i)].name, session_->middleOfTool(i));
  place("iso", session_->iso().handle());
  place("organ", session_->cells().lattice.box().centre());
  if (exercising()) {
    const std::vector<Vec3> targets = attempt_->progress().places;
    constexpr std::size_t kMost = 20;  // a line has hundreds of points
    for (std::size_t i = 0; i < std::min(kMost, targets.size()); ++i)
      place("target-" + std::to_string(i + 1), targets[i]);
    reportButtons(exercise_);
  }
  if (!makerDock_->isHidden()) reportButtons(maker_);
  for (const QAbstractSpinBox* field : findChildren<QAbstractSpinBox*>()) {
    if (!field->isVisible()) continue;
    const QPoint global = field->mapToGlobal(QPoint(field->width() / 4, field->height() / 2));
    say("place {} {} {}", field->accessibleName().toStdString(), int(global.x() * ratio),
        int(global.y() * ratio));
  }
  const auto [start, end] = timeline_->barEnds();
  say("place timeline-start {} {}", int(start.x() * ratio), int(start.y() * ratio));
  say("place timeline-end {} {}", int(end.x() * ratio), int(end.y() * ratio));
  reportCutText();
  say("places");
}

// Reports the middles of the buttons and fields in a widget, by their names.
void MainWindow::reportButtons(const QWidget* in) {
  const double ratio = devicePixelRatioF();
  for (const QWidget* one : in->findChildren<QWidget*>()) {
    const auto* button = qobject_cast<const QAbstractButton*>(one);
    const QString name = !one->accessibleName().isEmpty() ? one->accessibleName()
                         : button                         ? button->text()
                                                          : QString();
    const bool used =
        button || qobject_cast<const QComboBox*>(one) || qobject_cast<const QLineEdit*>(one) ||
        qobject_cast<const QPlainTextEdit*>(one) || qobject_cast<const QAbstractSpinBox*>(one);
    if (!used || name.isEmpty() || !one->isVisible() || one->visibleRegion().isEmpty()) continue;
    const QPoint at = one->mapToGlobal(one->visibleRegion().boundingRect().center());
    say("place {} {} {}", name.toStdString(), int(at.x() * ratio), int(at.y() * ratio));
  }
}

// Reports labels and buttons whose text does not fit.
void MainWindow::reportCutText() {
  // A window that is busy drawing may still have to lay its panels out.
  for (int level = 0; level < 4; ++level)
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  const auto cut = [](const QString& text) { say("cut text {}", text.toStdString()); };
  for (const QLabel* label : findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    if (label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored) continue;  // it elides
    const int needed =
        label->wordWrap() ? label->minimumSizeHint().width() : label->sizeHint().width();
    const int high =
        label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
    if (label->width() < needed || label->height() < high) cut(label->text());
  }
  for (const QAbstractButton* button : findChildren<QAbstractButton*>())
    if (button->isVisible() && !button->text().isEmpty() &&
        button->width() < button->minimumSizeHint().width())
      cut(button->text());
  // A panel that cannot be scrolled sideways must not be narrower than what it has.
  for (const QScrollArea* area : findChildren<QScrollArea*>()) {
    const int wide = area->widget()->width(), seen = area->viewport()->width();
    if (area->isVisible() && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
        wide > seen)
      cut(QString("%1: %2 of %3 pixels")
              .arg(area->parentWidget()->windowTitle())
              .arg(seen)
              .arg(wide));
  }
  for (const QTabBar* tabs : findChildren<QTabBar*>())
    for (int i = 0; tabs->isVisible() && i < tabs->count(); ++i)
      if (!tabs->rect().contains(tabs->tabRect(i)) || tabs->elideMode() != Qt::ElideNone)
        cut(tabs->tabText(i));
}

// Reports the moment that is shown, and that the operation goes on.
void MainWindow::reportMoment() {
  const LiveState& state = session_->state();
  const bool arrived = session_->showing() && state.showing && session_->answered();
  if (arrived && (!showingSaid_ || momentSaid_ != state.moment))
    say("showing branch {} frame {} removed {}", state.moment.branch, state.moment.frame,
        state.removed);
  if (showingSaid_ && !session_->showing()) say("operating");
  if (state.ledger && state.ledger != ledgerSaid_) {
    ledgerSaid_ = state.ledger;
    const TissueSplit all = state.ledger->tissue();
    say("ledger frame {} removed {:.3f} ml pieces {:.3f} ml debris {:.3f} ml cut {:.2f} cm2",
        state.frame, 1e6 * all.removed.volume, 1e6 * all.pieces.volume, 1e6 * all.debris.volume,
        1e4 * state.ledger->cut());
  }
  if (arrived) momentSaid_ = state.moment;
  if (arrived || !session_->showing()) showingSaid_ = session_->showing();
}

// Reports rates and latencies while somebody operates.
void MainWindow::reportPace() {
  for (const double force : session_->state().forces) forceSaid_ = std::max(forceSaid_, force);
  const auto pace = viewer_->pace().take();
  if (!pace) return;
  say("rate {:.1f} drawing {:.1f} ms latency {:.0f} ms most {:.0f} ms pictures {} late {} of {} "
      "removal {}",
      pace->rate, pace->drawing * 1e3, pace->latency * 1e3, pace->most * 1e3, pace->pictures,
      pace->late, pace->inputs, pace->removal);
  const SoOrganShape& organ = *session_->room().organ();
  say("uploaded {} of {} vertices", organ.uploadedVertices() - uploadedSaid_, organ.vertexCount());
  uploadedSaid_ = organ.uploadedVertices();
  if (session_->state().moves) say("force {:.2f} N", std::exchange(forceSaid_, 0));
}

}  // namespace resect

// The picture in the window: draws the operation, and turns mouse and keyboard input into Inventor
// events. When nothing moves the picture is drawn antialiased, strip by strip, so that input never
// waits for it.
//
// The picture is drawn offscreen and only changed pixels go to the screen: a QOpenGLWidget would
// compose the whole window each time, which in software costs as much as the drawing
// (docs/decisions/0003).
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QMouseEvent>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

#include "app/pace.h"
#include "formats/png_file.h"
#include "inventor/gl/damage.h"
#include "inventor/picture/live_picture.h"

class QInputEvent;
class SoEvent;
class SbViewportRegion;

namespace resect {

class OperatingSession;

class Viewer : public QWidget {
 public:
  // Throws Error in one sentence where nothing can be drawn.
  explicit Viewer(QWidget* parent = nullptr);

  // Shows this session; nullptr: nothing. The session must outlive its display.
  void show(OperatingSession* session);
  void setFpsLimit(double framesPerSecond);

  double aspect() const { return double(width()) / std::max(1, height()); }
  SbViewportRegion viewport() const;  // device pixels
  struct Drawing {
    double perSecond = 0, seconds = 0;  // pictures of the last second, and what one of them took
  };
  Drawing drawing() const;
  Pace& pace() { return pace_; }
  // The picture as shown; `smooth`: drawn anew with smooth edges.
  RgbImage grabPicture(bool smooth);

  std::function<void()> ticked;  // after each update from the operation
  // Called first; true if it handled the event.
  std::function<bool(const SoEvent&, const SbViewportRegion&)> before;
  std::function<void(const std::string&)> failed;  // a sentence

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override { mouseButton(event, true); }
  void mouseReleaseEvent(QMouseEvent* event) override { mouseButton(event, false); }
  void mouseDoubleClickEvent(QMouseEvent* event) override { mouseButton(event, true); }
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override { key(event, true); }
  void keyReleaseEvent(QKeyEvent* event) override { key(event, false); }

 private:
  void tick();
  void waitForNext();
  void mouseButton(QMouseEvent* event, bool down) { mouseButton(*event, event->button(), down); }
  void mouseButton(const QMouseEvent& event, Qt::MouseButton button, bool down);
  void key(QKeyEvent* event, bool down);
  bool send(SoEvent& event, const QInputEvent& from, const QPointF& at);
  void drawChanges(double looked);  // time of the update from the operation, s
  void drawStrip(int strip);
  QSize pictureSize() const;
  QRegion fetch(std::span<const PixelRect> parts);

  OperatingSession* session_ = nullptr;
  QTimer timer_, soon_;
  double interval_ = 1.0 / 60;  // s
  QElapsedTimer clock_, still_;
  LivePicture picture_;
  QImage image_;  // what is on the screen
  Damage damage_;
  int strip_ = 0;       // the next of the smooth picture
  int behind_ = 0;      // the same for still parts behind moving tissue
  int sinceStrip_ = 0;  // pictures
  Qt::MouseButtons down_;
  std::vector<std::pair<double, double>> drawn_;  // the last pictures: when, and how long, s
  double due_ = 0;                                // time of the next update, s
  Pace pace_;
  double wheel_ = 0;  // degrees not yet turned into steps
};

}  // namespace resect

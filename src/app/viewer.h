// The picture in the window: draws the operation, and turns mouse and keyboard into Inventor
// events. Once all stands still the picture is drawn in full, with smooth edges.
#pragma once

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QOpenGLWidget>
#include <QTimer>
#include <functional>
#include <memory>

#include "app/pace.h"
#include "inventor/damage.h"
#include "inventor/live_picture.h"
#include "io/png_file.h"

class QInputEvent;
class SoEvent;
class SbViewportRegion;

namespace resect {

class OperatingSession;

class Viewer : public QOpenGLWidget {
 public:
  explicit Viewer(QWidget* parent = nullptr);
  ~Viewer() override;

  // Shows this session; nullptr: nothing. The session must outlive its showing.
  void show(OperatingSession* session);
  void setFpsLimit(double framesPerSecond);

  double aspect() const { return double(width()) / std::max(1, height()); }
  SbViewportRegion viewport() const;  // device pixels
  double framesPerSecond() const;     // of the pictures drawn lately
  double scaleInMotion() const;       // share of the pixels' rows drawn in motion
  Pace& pace() { return pace_; }
  // The picture as shown; `full`: drawn anew with all pixels and smooth edges.
  RgbImage grabPicture(bool full);

  std::function<void()> ticked;  // after each look at the operation
  // Asked first: true when it used the event.
  std::function<bool(const SoEvent&, const SbViewportRegion&)> before;
  std::function<void(const std::string&)> failed;  // a sentence

 protected:
  void initializeGL() override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override { mouseButton(event, true); }
  void mouseReleaseEvent(QMouseEvent* event) override { mouseButton(event, false); }
  void mouseDoubleClickEvent(QMouseEvent* event) override { mouseButton(event, true); }
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override { key(event, true); }
  void keyReleaseEvent(QKeyEvent* event) override { key(event, false); }

 private:
  void tick();
  void mouseButton(QMouseEvent* event, bool down) { mouseButton(*event, event->button(), down); }
  void mouseButton(const QMouseEvent& event, Qt::MouseButton button, bool down);
  void key(QKeyEvent* event, bool down);
  bool send(SoEvent& event, const QInputEvent& from, const QPointF& at);
  void forgetContext();

  OperatingSession* session_ = nullptr;
  QTimer timer_;
  QElapsedTimer clock_, still_;
  std::unique_ptr<LivePicture> picture_;
  Damage damage_;
  bool full_ = false;  // the next picture is drawn in full
  bool fullShown_ = false;
  bool grabbing_ = false;
  Qt::MouseButtons down_;
  std::vector<double> drawn_;  // times of the last pictures, s
  Pace pace_;
  double wheel_ = 0;  // degrees not yet turned into steps
};

}  // namespace resect

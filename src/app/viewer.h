// The picture in the window: draws the operation, and turns mouse and keyboard input into Inventor
// events. When nothing moves, the picture is drawn antialiased, strip by strip, so that input never
// waits for a whole picture. While something moves, strips are antialiased less often.
//
// The picture is drawn offscreen, and only changed pixels go to the screen. A QOpenGLWidget would
// draw the whole window again for each picture (docs/decisions/0003).
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
  // Throws Error if there is no OpenGL context to draw with.
  explicit Viewer(QWidget* parent = nullptr);

  // Shows this session. If `session` is null, no operation is shown. The session must exist as long
  // as it is shown.
  void show(OperatingSession* session);
  // Sets the text that is shown while there is no session. It says what the user is waiting for.
  void sayWaiting(const QString& what);
  void setFpsLimit(double framesPerSecond);

  double aspect() const { return double(width()) / std::max(1, height()); }
  SbViewportRegion viewport() const;  // device pixels
  struct Drawing {
    // Number of pictures drawn in the last second; mean time to draw a picture, s.
    double perSecond = 0, seconds = 0;
  };
  Drawing drawing() const;
  Pace& pace() { return pace_; }
  bool showsPicture() const { return !image_.isNull(); }
  // The picture as it is shown. If `smooth` is true, the picture is first drawn again with
  // antialiased edges.
  RgbImage grabPicture(bool smooth);

  std::function<void()> ticked;  // called after each update from the operation
  // Called with each event. If the function returns true, the session does not get the event.
  std::function<bool(const SoEvent&, const SbViewportRegion&)> before;

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
  void drawChanges(double looked);  // `looked`: time of the shown state, steadySeconds()
  double seconds() const { return double(clock_.nsecsElapsed()) * 1e-9; }
  void drawStrip(int strip);
  void drawNextStrip(std::uint32_t& strips);
  void sharpenStrips();
  void takeSlowDamage();
  std::uint32_t stripsOf(std::span<const PixelRect> parts) const;
  QSize pictureSize() const;
  QRegion fetch(std::span<const PixelRect> parts);

  OperatingSession* session_ = nullptr;
  QTimer timer_, soon_;
  double interval_ = 1.0 / 60;  // time from one update to the next, s
  QElapsedTimer clock_, still_;
  LivePicture picture_;
  QImage image_;  // the picture on the screen
  Damage damage_;
  // Sets of strips of the picture: bit i is strip i, counted from below.
  std::uint32_t coarse_ = 0;  // strips in which something is drawn at a lower resolution
  std::uint32_t rough_ = 0;   // strips that are not antialiased yet
  std::uint32_t behind_ = 0;  // strips to be antialiased while something moves
  int sinceStrip_ = 0;        // pictures drawn since one strip was antialiased
  bool shadowsDue_ = false;   // the next strip also draws the changed shadows
  double slowDrawn_ = 0;      // last time when Damage::slow was drawn again, s
  double stripDrawn_ = 0;     // last time when a strip was drawn while something moved, s
  double lastInput_ = 0;      // time of the last input, s
  double pauseEnds_ = 0;      // earliest time for an antialiased picture of moving parts, s
  QString waiting_;           // text shown in place of a picture
  Qt::MouseButtons down_;
  // For each of the last pictures, at most 240: the time when the picture was finished, and the
  // time that drawing it took, s.
  std::vector<std::pair<double, double>> drawn_;
  double due_ = 0;  // when the next update is due, s
  Pace pace_;
  double wheel_ = 0;  // degrees that the wheel has turned since its last whole step
};

}  // namespace resect

#include "app/viewer.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/nodes/SoNode.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>

#include "inventor/operating_session.h"

namespace resect {
namespace {

constexpr double kStillSeconds = 0.25;  // after this the picture is drawn in full

int inventorKey(int key) {
  if (key >= Qt::Key_A && key <= Qt::Key_Z) return SoKeyboardEvent::A + (key - Qt::Key_A);
  if (key >= Qt::Key_0 && key <= Qt::Key_9) return SoKeyboardEvent::NUMBER_0 + (key - Qt::Key_0);
  switch (key) {
    case Qt::Key_Escape:
      return SoKeyboardEvent::ESCAPE;
    case Qt::Key_Left:
      return SoKeyboardEvent::LEFT_ARROW;
    case Qt::Key_Right:
      return SoKeyboardEvent::RIGHT_ARROW;
    case Qt::Key_Up:
      return SoKeyboardEvent::UP_ARROW;
    case Qt::Key_Down:
      return SoKeyboardEvent::DOWN_ARROW;
    case Qt::Key_PageUp:
      return SoKeyboardEvent::PAGE_UP;
    case Qt::Key_PageDown:
      return SoKeyboardEvent::PAGE_DOWN;
    default:
      return SoKeyboardEvent::ANY;
  }
}

}  // namespace

Viewer::Viewer(QWidget* parent) : QOpenGLWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(320, 240);
  clock_.start();
  still_.start();
  QObject::connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  timer_.setTimerType(Qt::PreciseTimer);
  QObject::connect(this, &QOpenGLWidget::frameSwapped, this, [this] { pace_.pictureShown(); });
  setFpsLimit(60);
}

Viewer::~Viewer() { forgetContext(); }

void Viewer::forgetContext() {
  if (!picture_) return;
  makeCurrent();
  picture_.reset();
  doneCurrent();
}

double Viewer::scaleInMotion() const { return picture_ ? picture_->scale() : 1; }

void Viewer::setFpsLimit(double fps) { timer_.setInterval(std::max(1, int(1000 / fps))); }

void Viewer::show(OperatingSession* session) {
  session_ = session;
  damage_.everything = true;
  full_ = true;
  timer_.start();
  update();
}

SbViewportRegion Viewer::viewport() const {
  const double ratio = devicePixelRatioF();
  return SbViewportRegion(short(std::lround(width() * ratio)),
                          short(std::lround(height() * ratio)));
}

double Viewer::framesPerSecond() const {
  if (drawn_.size() < 2) return 0;
  const double now = double(clock_.nsecsElapsed()) * 1e-9;
  const auto recent =
      std::count_if(drawn_.begin(), drawn_.end(), [&](double t) { return now - t < 1.0; });
  return double(recent);
}

void Viewer::tick() {
  if (!session_) return;
  const Damage damage = session_->update();
  damage_.add(damage);
  if (!damage_.empty()) {
    still_.restart();
    full_ = false;
    fullShown_ = picture_ && !picture_->processorDraws();
    update();
  } else if (!fullShown_ && double(still_.elapsed()) * 1e-3 > kStillSeconds) {
    full_ = true;
    update();
  }
  if (ticked) ticked();
}

void Viewer::initializeGL() {
  picture_ = std::make_unique<LivePicture>();
  QObject::connect(context(), &QOpenGLContext::aboutToBeDestroyed, this,
                   [this] { forgetContext(); });
}

void Viewer::paintGL() {
  if (!session_ || !picture_) {
    QOpenGLFunctions* gl = context()->functions();
    gl->glClearColor(0.05f, 0.06f, 0.07f, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    return;
  }
  // What has happened since the last tick is in this picture, not the next.
  const Damage fresh = session_->update();
  if (!fresh.empty() && !grabbing_) full_ = false;
  damage_.add(fresh);
  pace_.pictureBegins(session_->state().lastRemoval);
  session_->room().setShadowResolution(picture_->processorDraws() ? 512 : 1024);
  picture_->draw(session_->root(), *session_->room().camera(), damage_, viewport().getWindowSize(),
                 full_, defaultFramebufferObject());
  pace_.pictureIsDrawn();
  damage_ = {};
  fullShown_ = full_ || !picture_->processorDraws();
  full_ = false;
  drawn_.push_back(double(clock_.nsecsElapsed()) * 1e-9);
  if (drawn_.size() > 240) drawn_.erase(drawn_.begin(), drawn_.begin() + 120);
}

RgbImage Viewer::grabPicture(bool full) {
  full_ = full_ || full;
  grabbing_ = true;
  const QImage grabbed = grabFramebuffer();
  grabbing_ = false;
  const QImage image = grabbed.convertToFormat(QImage::Format_RGB888);
  RgbImage result{image.width(), image.height(), {}};
  for (int y = 0; y < image.height(); ++y)
    result.pixels.insert(result.pixels.end(), image.constScanLine(y),
                         image.constScanLine(y) + 3 * image.width());
  return result;
}

bool Viewer::send(SoEvent& event, const QInputEvent& from, const QPointF& at) {
  if (!session_) return false;
  const Qt::KeyboardModifiers modifiers = from.modifiers();
  const SbViewportRegion region = viewport();
  const double ratio = devicePixelRatioF();
  event.setPosition(SbVec2s(short(std::lround(at.x() * ratio)),
                            short(region.getWindowSize()[1] - 1 - std::lround(at.y() * ratio))));
  event.setTime(SbTime::getTimeOfDay());
  event.setShiftDown(modifiers.testFlag(Qt::ShiftModifier));
  event.setCtrlDown(modifiers.testFlag(Qt::ControlModifier));
  event.setAltDown(modifiers.testFlag(Qt::AltModifier));
  if (before && before(event, region)) return true;
  const bool used = session_->handle(event, region);
  if (used && session_->pending()) pace_.inputCame(steadySecondsOf(from.timestamp()));
  return used;
}

void Viewer::mouseButton(const QMouseEvent& event, Qt::MouseButton button, bool down) {
  down_.setFlag(button, down);
  SoMouseButtonEvent mouse;
  switch (button) {
    case Qt::LeftButton:
      mouse.setButton(SoMouseButtonEvent::BUTTON1);
      break;
    case Qt::MiddleButton:
      mouse.setButton(SoMouseButtonEvent::BUTTON2);
      break;
    case Qt::RightButton:
      mouse.setButton(SoMouseButtonEvent::BUTTON3);
      break;
    default:
      return;
  }
  mouse.setState(down ? SoButtonEvent::DOWN : SoButtonEvent::UP);
  send(mouse, event, event.position());
}

void Viewer::mouseMoveEvent(QMouseEvent* event) {
  // A dialog that opens during a drag takes the release of its button.
  for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton})
    if (down_.testFlag(button) && !event->buttons().testFlag(button))
      mouseButton(*event, button, false);
  SoLocation2Event moved;
  send(moved, *event, event->position());
}

void Viewer::wheelEvent(QWheelEvent* event) {
  // A notch is 15 degrees; touch pads send parts of one.
  wheel_ +=
      (event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x()) / 8.0;
  while (std::abs(wheel_) >= 15) {
    SoMouseButtonEvent notch;
    notch.setButton(wheel_ > 0 ? SoMouseButtonEvent::BUTTON4 : SoMouseButtonEvent::BUTTON5);
    notch.setState(SoButtonEvent::DOWN);
    send(notch, *event, event->position());
    wheel_ += wheel_ > 0 ? -15 : 15;
  }
}

void Viewer::key(QKeyEvent* event, bool down) {
  SoKeyboardEvent keyboard;
  keyboard.setKey(SoKeyboardEvent::Key(inventorKey(event->key())));
  keyboard.setState(down ? SoButtonEvent::DOWN : SoButtonEvent::UP);
  const QPoint at = mapFromGlobal(QCursor::pos());
  if (!send(keyboard, *event, at))
    down ? QOpenGLWidget::keyPressEvent(event) : QOpenGLWidget::keyReleaseEvent(event);
}

}  // namespace resect

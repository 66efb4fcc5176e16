#include "app/viewer.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/nodes/SoNode.h>

#include <QPaintEvent>
#include <QPainter>
#include <algorithm>
#include <bit>
#include <cmath>

#include "base/stage_clock.h"
#include "inventor/hand/operating_session.h"

namespace resect {
namespace {

constexpr double kStillSeconds = 0.1;  // after this the picture is drawn sharp, then antialiased
constexpr double kSlowSeconds = 0.25;  // at least, from one drawing of slow damage to the next
constexpr int kStrips = 10;            // of a smooth picture, one a tick
constexpr int kSharpStrips = 3;        // drawn together at full resolution
constexpr std::uint32_t kAllStrips = (1u << kStrips) - 1;
constexpr int kPicturesPerStrip = 6;   // while something moves,
constexpr double kStripSeconds = 0.1;  // or after this time
// After this without input the hand rests: what moves by itself is drawn at full resolution,
// however long that takes. Then the window rests for this share of that time.
constexpr double kHandRests = 0.4, kPause = 0.5;

int inventorKey(int key) {
  if (key >= Qt::Key_A && key <= Qt::Key_Z) return SoKeyboardEvent::A + (key - Qt::Key_A);
  if (key >= Qt::Key_0 && key <= Qt::Key_9) return SoKeyboardEvent::NUMBER_0 + (key - Qt::Key_0);
  switch (key) {
    case Qt::Key_Minus:
      return SoKeyboardEvent::MINUS;
    case Qt::Key_Equal:
      return SoKeyboardEvent::EQUAL;
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

Viewer::Viewer(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(320, 240);
  setAttribute(Qt::WA_OpaquePaintEvent);
  clock_.start();
  still_.start();
  // A zero-length timer fires after all pending input is handled, so that the picture that begins
  // now includes it.
  soon_.setSingleShot(true);
  QObject::connect(&timer_, &QTimer::timeout, &soon_, [this] {
    waitForNext();
    soon_.start(0);
  });
  QObject::connect(&soon_, &QTimer::timeout, this, [this] { tick(); });
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  setFpsLimit(60);
}

void Viewer::setFpsLimit(double fps) { interval_ = 1 / fps; }

// The timer counts whole milliseconds; the error is compensated in the next wait.
void Viewer::waitForNext() {
  const double now = seconds();
  due_ = std::max(due_ + interval_, now);
  timer_.start(std::max(1, int(std::lround(1e3 * (due_ - now)))));
}

void Viewer::show(OperatingSession* session) {
  session_ = session;
  damage_ = {};
  damage_.everything = true;
  session ? waitForNext() : timer_.stop();
  image_ = {};
  update();
}

SbViewportRegion Viewer::viewport() const {
  const double ratio = devicePixelRatioF();
  return SbViewportRegion(short(std::lround(width() * ratio)),
                          short(std::lround(height() * ratio)));
}

Viewer::Drawing Viewer::drawing() const {
  const double now = seconds();
  Drawing recent;
  for (const auto& [when, seconds] : drawn_)
    if (now - when < 1.0) ++recent.perSecond, recent.seconds += seconds;
  if (recent.perSecond > 0) recent.seconds /= recent.perSecond;
  return recent;
}

void Viewer::tick() {
  if (!session_) return;
  const double looked = steadySeconds();
  damage_.add(session_->update());
  session_->noteSight(viewport());
  takeSlowDamage();
  const double still = double(still_.elapsed()) * 1e-3;
  if (!isVisible() || window()->isMinimized()) {
    // Damage is drawn when the window is visible again.
  } else if (!damage_.empty() || image_.size() != pictureSize()) {
    still_.restart();
    const double now = seconds();
    const bool rests = now - lastInput_ > kHandRests && !session_->playing();
    if (!rests || now >= pauseEnds_) {
      picture_.setSharp(rests);
      drawChanges(looked);
      pauseEnds_ = seconds() + kPause * (seconds() - now);
    }
    // While tissue moves, still parts behind it are drawn smooth strip by strip.
    const bool due = ++sinceStrip_ >= kPicturesPerStrip || seconds() > stripDrawn_ + kStripSeconds;
    if (behind_ != 0 && due) {
      drawNextStrip(behind_);
      sinceStrip_ = 0;
      stripDrawn_ = seconds();
    }
  } else if (still > kStillSeconds && rough_ != 0) {
    // Shadows of what moves slowly are drawn once for all strips.
    session_->room().holdShadows(!std::exchange(shadowsDue_, false));
    if (coarse_ != 0) {
      sharpenStrips();
    } else {
      drawNextStrip(rough_);
      behind_ &= rough_;
    }
  }
  if (ticked) ticked();
}

void Viewer::drawNextStrip(std::uint32_t& strips) {
  const int strip = std::countr_zero(strips);
  strips &= strips - 1;
  coarse_ &= ~(1u << strip);
  drawStrip(strip);
}

// Draws the lowest coarse strips at full resolution, for the eye sees coarse pixels first.
void Viewer::sharpenStrips() {
  const int first = std::countr_zero(coarse_);
  const int end =
      std::min({first + std::countr_one(coarse_ >> first), first + kSharpStrips, kStrips});
  for (int i = first; i < end; ++i) coarse_ &= ~(1u << i);
  if (image_.size() != pictureSize()) return;
  const PixelRect part = picture_.drawSharp(session_->root(), first, end, kStrips);
  repaint(fetch(std::span(&part, 1)));
}

// Slow damage makes its strips rough: they are drawn again, one a tick, at full resolution.
void Viewer::takeSlowDamage() {
  if (damage_.slow.empty() || image_.isNull()) return;
  if (!picture_.processorDraws()) {
    damage_.boxes.push_back(std::exchange(damage_.slow, {}));
    return;
  }
  const double now = seconds();
  if (rough_ != 0 || behind_ != 0 || now - slowDrawn_ < kSlowSeconds) return;
  slowDrawn_ = now;
  const Damage slow{false, {std::exchange(damage_.slow, {})}, {}};
  const std::uint32_t strips = stripsOf(pixelsOf(slow, *session_->room().camera(), viewport()));
  rough_ |= strips;
  behind_ |= strips;
  shadowsDue_ = true;
}

// The strips that have any of these pixels.
std::uint32_t Viewer::stripsOf(std::span<const PixelRect> parts) const {
  const int height = pictureSize().height();
  std::uint32_t strips = 0;
  for (const PixelRect& part : parts)
    for (int i = 0; i < kStrips; ++i)
      if (part.bottom < height * (i + 1) / kStrips && part.top > height * i / kStrips)
        strips |= 1u << i;
  return strips;
}

void Viewer::drawChanges(double looked) {
  const double begin = seconds();
  const bool whole = damage_.everything || image_.size() != pictureSize();
  pace_.pictureBegins(looked, session_->state().lastRemoval);
  session_->room().setShadowResolution(picture_.processorDraws() ? 512 : 1024);
  session_->room().holdShadows(!picture_.shadowsAreDue(damage_));
  const QRegion changed = fetch(picture_.draw(session_->root(), *session_->room().camera(), damage_,
                                              viewport().getWindowSize()));
  pace_.pictureIsDrawn();
  std::uint32_t changedStrips = kAllStrips;
  if (!picture_.processorDraws()) {
    rough_ = behind_ = 0;
  } else if (whole) {
    rough_ = behind_ = kAllStrips;
    sinceStrip_ = 0;
  } else {
    damage_.add({false, damage_.shadows, {}});
    changedStrips = stripsOf(pixelsOf(damage_, *session_->room().camera(), viewport()));
    rough_ |= changedStrips;
  }
  if (picture_.reduced()) coarse_ |= changedStrips;
  const Aabb slow = whole ? Aabb() : damage_.slow;
  damage_ = {};
  damage_.slow = slow;
  shadowsDue_ = true;
  repaint(changed);
  pace_.pictureShown();
  const double end = seconds();
  drawn_.push_back({end, end - begin});
  if (drawn_.size() > 240) drawn_.erase(drawn_.begin(), drawn_.begin() + 120);
}

void Viewer::drawStrip(int strip) {
  // The picture was resized since it was drawn: its strips are no longer those of the image.
  if (image_.size() != pictureSize()) return;
  const PixelRect part = picture_.drawSmooth(session_->root(), strip, kStrips);
  repaint(fetch(std::span(&part, 1)));
}

QSize Viewer::pictureSize() const {
  const SbVec2s size = viewport().getWindowSize();
  return QSize(size[0], size[1]);
}

// Returns the widget's changed region. The picture uses device pixels, from below.
QRegion Viewer::fetch(std::span<const PixelRect> parts) {
  const double ratio = devicePixelRatioF();
  if (image_.size() != pictureSize()) image_ = QImage(pictureSize(), QImage::Format_RGB32);
  image_.setDevicePixelRatio(ratio);
  QRegion changed;
  for (const PixelRect& part : parts) {
    const int top = image_.height() - part.top;
    auto* pixels = reinterpret_cast<std::uint32_t*>(image_.scanLine(top)) + part.left;
    picture_.read(part, pixels, image_.bytesPerLine() / 4);
    changed += QRectF(part.left / ratio, top / ratio, (part.right - part.left) / ratio,
                      (part.top - part.bottom) / ratio)
                   .toAlignedRect();
  }
  return changed;
}

void Viewer::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  const QSizeF shown = image_.deviceIndependentSize();
  if (shown.width() < width() || shown.height() < height())
    painter.fillRect(event->rect(), QColor(13, 15, 18));
  painter.drawImage(QPointF(0, 0), image_);
  if (session_ || waiting_.isEmpty()) return;
  QFont large = font();
  large.setPointSizeF(2.4 * font().pointSizeF());
  painter.setFont(large);
  painter.setPen(QColor(222, 228, 230));
  QRect line(0, height() / 2 - 2 * QFontMetrics(large).height(), width(),
             QFontMetrics(large).height());
  painter.drawText(line, Qt::AlignCenter, QStringLiteral("Resect"));
  painter.setFont(font());
  painter.drawText(QRect(20, height() / 2, width() - 40, height() / 2),
                   Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, waiting_);
}

void Viewer::sayWaiting(const QString& what) {
  if (what == waiting_) return;
  waiting_ = what;
  if (!session_) update();
}

RgbImage Viewer::grabPicture(bool smooth) {
  if (smooth && session_) {
    drawChanges(steadySeconds());
    session_->room().holdShadows(false);
    for (rough_ = kAllStrips; rough_ != 0;) drawNextStrip(rough_);
    behind_ = 0;
  }
  const QImage image = image_.convertToFormat(QImage::Format_RGB888);
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
  lastInput_ = seconds();
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
  // A dialog opened during a drag receives the button's release.
  for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton})
    if (down_.testFlag(button) && !event->buttons().testFlag(button))
      mouseButton(*event, button, false);
  SoLocation2Event moved;
  send(moved, *event, event->position());
}

void Viewer::wheelEvent(QWheelEvent* event) {
  // A wheel step is 15 degrees; touch pads send fractions.
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
  if (!down && event->isAutoRepeat()) return;  // the key is still held down
  SoKeyboardEvent keyboard;
  keyboard.setKey(SoKeyboardEvent::Key(inventorKey(event->key())));
  keyboard.setState(down ? SoButtonEvent::DOWN : SoButtonEvent::UP);
  const QPoint at = mapFromGlobal(QCursor::pos());
  if (!send(keyboard, *event, at))
    down ? QWidget::keyPressEvent(event) : QWidget::keyReleaseEvent(event);
}

}  // namespace resect

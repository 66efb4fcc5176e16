#include "app/viewer.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/misc/SoContextHandler.h>
#include <Inventor/nodes/SoNode.h>

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>

#include "inventor/operating_session.h"

namespace resect {
namespace {

constexpr double kStillSeconds = 0.25;  // after this the picture is drawn in full
constexpr double kScales[] = {1.0, 0.85, 0.7, 0.6, 0.5, 0.4};

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
  setFpsLimit(60);
}

Viewer::~Viewer() { forgetContext(); }

void Viewer::forgetContext() {
  if (!action_) return;
  makeCurrent();
  SoContextHandler::destructingContext(action_->getCacheContext());
  action_.reset();
  buffer_.reset();
  shown_.reset();
  doneCurrent();
}

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
  damage_.everything = damage_.everything || damage.everything;
  damage_.boxes.insert(damage_.boxes.end(), damage.boxes.begin(), damage.boxes.end());
  if (!damage_.empty()) {
    still_.restart();
    full_ = !software_;
    fullShown_ = false;
    update();
  } else if (!fullShown_ && double(still_.elapsed()) * 1e-3 > kStillSeconds) {
    full_ = true;
    update();
  }
  if (ticked) ticked();
}

void Viewer::initializeGL() {
  const auto* name =
      reinterpret_cast<const char*>(context()->functions()->glGetString(GL_RENDERER));
  renderer_ = name ? name : "unknown";
  software_ = renderer_.find("llvmpipe") != std::string::npos ||
              renderer_.find("softpipe") != std::string::npos;
  if (software_) scale_ = 0.7;
  action_ = std::make_unique<SoGLRenderAction>(viewport());
  action_->setCacheContext(SoGLCacheContextElement::getUniqueCacheContext());
  QObject::connect(context(), &QOpenGLContext::aboutToBeDestroyed, this,
                   [this] { forgetContext(); });
}

// All of the scene, or the pixels of `part`.
void Viewer::draw(QOpenGLFramebufferObject& buffer, const PixelRect* part) {
  buffer.bind();
  QOpenGLFunctions* gl = context()->functions();
  gl->glViewport(0, 0, buffer.width(), buffer.height());
  if (part) {
    gl->glEnable(GL_SCISSOR_TEST);
    gl->glScissor(part->left, part->bottom, part->right - part->left, part->top - part->bottom);
  }
  gl->glClearColor(0, 0, 0, 1);
  gl->glDepthMask(GL_TRUE);
  gl->glEnable(GL_DEPTH_TEST);
  gl->glDepthFunc(GL_LEQUAL);
  gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  action_->invalidateState();
  action_->setViewportRegion(SbViewportRegion(short(buffer.width()), short(buffer.height())));
  action_->apply(session_->root());
  gl->glDisable(GL_SCISSOR_TEST);
}

void Viewer::paintGL() {
  QOpenGLFunctions* gl = context()->functions();
  QOpenGLExtraFunctions* extra = context()->extraFunctions();
  const SbVec2s size = viewport().getWindowSize();
  if (!session_) {
    gl->glClearColor(0.05f, 0.06f, 0.07f, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    return;
  }
  QElapsedTimer time;
  time.start();
  if (!shown_ || shown_->width() != size[0] || shown_->height() != size[1]) {
    shown_ = std::make_unique<QOpenGLFramebufferObject>(
        size[0], size[1], QOpenGLFramebufferObject::CombinedDepthStencil);
    damage_.everything = true;
  }
  const auto copy = [&](QOpenGLFramebufferObject& from, GLuint to, GLenum filter) {
    extra->glBindFramebuffer(GL_READ_FRAMEBUFFER, from.handle());
    extra->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    extra->glBlitFramebuffer(0, 0, from.width(), from.height(), 0, 0, size[0], size[1],
                             GL_COLOR_BUFFER_BIT, filter);
  };
  const auto buffer = [&](int width, int height, int samples) -> QOpenGLFramebufferObject& {
    if (!buffer_ || buffer_->width() != width || buffer_->height() != height ||
        buffer_->format().samples() != samples) {
      QOpenGLFramebufferObjectFormat format;
      format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
      format.setSamples(samples);
      buffer_ = std::make_unique<QOpenGLFramebufferObject>(width, height, format);
    }
    return *buffer_;
  };
  const std::vector<PixelRect> parts = pixelsOf(damage_, *session_->room().camera(), viewport());
  const std::int64_t affordable = std::int64_t(scale_ * scale_ * size[0] * size[1]);
  session_->room().setShadowResolution(software_ ? 512 : 1024);
  if (full_) {
    QOpenGLFramebufferObject& smooth = buffer(size[0], size[1], 4);
    draw(smooth, nullptr);
    copy(smooth, shown_->handle(), GL_NEAREST);
  } else if (area(parts) <= affordable) {
    for (const PixelRect& part : parts) draw(*shown_, &part);
  } else {
    QOpenGLFramebufferObject& coarse =
        buffer(std::max(16, int(size[0] * scale_)), std::max(16, int(size[1] * scale_)), 0);
    draw(coarse, nullptr);
    copy(coarse, shown_->handle(), GL_LINEAR);
  }
  copy(*shown_, defaultFramebufferObject(), GL_NEAREST);
  extra->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  if (software_ && !full_ && !parts.empty()) {
    gl->glFinish();
    const double ms = double(time.nsecsElapsed()) * 1e-6;
    const auto* at = std::find(std::begin(kScales), std::end(kScales), scale_);
    if (at == std::end(kScales)) at = std::begin(kScales) + 2;
    if (ms > 30 && at + 1 != std::end(kScales))
      ++at;
    else if (ms < 15 && area(parts) > affordable / 2 && at != std::begin(kScales))
      --at;
    scale_ = *at;
  }
  damage_ = {};
  fullShown_ = full_;
  full_ = !software_;
  drawn_.push_back(double(clock_.nsecsElapsed()) * 1e-9);
  if (drawn_.size() > 240) drawn_.erase(drawn_.begin(), drawn_.begin() + 120);
}

RgbImage Viewer::grabPicture(bool full) {
  full_ = full_ || full;
  const QImage image = grabFramebuffer().convertToFormat(QImage::Format_RGB888);
  RgbImage result{image.width(), image.height(), {}};
  for (int y = 0; y < image.height(); ++y)
    result.pixels.insert(result.pixels.end(), image.constScanLine(y),
                         image.constScanLine(y) + 3 * image.width());
  return result;
}

bool Viewer::send(SoEvent& event, const QPointF& at, Qt::KeyboardModifiers modifiers) {
  if (!session_) return false;
  const SbViewportRegion region = viewport();
  const double ratio = devicePixelRatioF();
  event.setPosition(SbVec2s(short(std::lround(at.x() * ratio)),
                            short(region.getWindowSize()[1] - 1 - std::lround(at.y() * ratio))));
  event.setTime(SbTime::getTimeOfDay());
  event.setShiftDown(modifiers.testFlag(Qt::ShiftModifier));
  event.setCtrlDown(modifiers.testFlag(Qt::ControlModifier));
  event.setAltDown(modifiers.testFlag(Qt::AltModifier));
  if (before && before(event, region)) return true;
  return session_->handle(event, region);
}

void Viewer::mouseButton(QMouseEvent* event, bool down) {
  SoMouseButtonEvent mouse;
  switch (event->button()) {
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
  send(mouse, event->position(), event->modifiers());
}

void Viewer::mouseMoveEvent(QMouseEvent* event) {
  SoLocation2Event moved;
  send(moved, event->position(), event->modifiers());
}

void Viewer::wheelEvent(QWheelEvent* event) {
  // A notch is 15 degrees; touch pads send parts of one.
  wheel_ +=
      (event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x()) / 8.0;
  while (std::abs(wheel_) >= 15) {
    SoMouseButtonEvent notch;
    notch.setButton(wheel_ > 0 ? SoMouseButtonEvent::BUTTON4 : SoMouseButtonEvent::BUTTON5);
    notch.setState(SoButtonEvent::DOWN);
    send(notch, event->position(), event->modifiers());
    wheel_ += wheel_ > 0 ? -15 : 15;
  }
}

void Viewer::key(QKeyEvent* event, bool down) {
  SoKeyboardEvent keyboard;
  keyboard.setKey(SoKeyboardEvent::Key(inventorKey(event->key())));
  keyboard.setState(down ? SoButtonEvent::DOWN : SoButtonEvent::UP);
  const QPoint at = mapFromGlobal(QCursor::pos());
  if (!send(keyboard, at, event->modifiers()))
    down ? QOpenGLWidget::keyPressEvent(event) : QOpenGLWidget::keyReleaseEvent(event);
}

}  // namespace resect

#include "app/widgets/surface_view.h"

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoTransform.h>

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <numbers>

#include "app/language/words.h"
#include "inventor/scene/model_nodes.h"

namespace resect {
namespace {

constexpr double kTurn = 2 * std::numbers::pi / 12;  // rad/s: a turn in twelve seconds
constexpr int kPause = 40;                           // ms between pictures, besides drawing
constexpr double kPerPixel = 0.01;                   // rad that the mouse turns
constexpr double kCamera = 2.7;                      // distance, in radii of the surface

SoDirectionalLight* lightFrom(float x, float y, float z, float intensity) {
  auto* light = new SoDirectionalLight;
  light->direction.setValue(-x, -y, -z);
  light->intensity = intensity;
  return light;
}

}  // namespace

SurfaceView::SurfaceView(QWidget* parent) : QWidget(parent) {
  setFixedSize(kSide, kSide);
  setToolTip(Words::tr(
      "What is opened; drag to turn it. L, R: the patient's left and right; A, P: front and back; "
      "H, F: head and feet"));
  setCursor(Qt::OpenHandCursor);
  timer_.setSingleShot(true);
  timer_.setInterval(kPause);
  connect(&timer_, &QTimer::timeout, this, [this] { turn(); });
}

SurfaceView::~SurfaceView() {
  if (root_) root_->unref();
}

void SurfaceView::setSurface(const TriangleMesh& mesh) {
  if (!view_) view_ = std::make_unique<OffscreenView>(kSide, kSide);
  if (root_) root_->unref();
  root_ = new SoSeparator;
  root_->ref();
  auto* camera = new SoPerspectiveCamera;
  camera->position.setValue(0, 0, float(kCamera));
  camera->nearDistance = float(kCamera - 1.2);
  camera->farDistance = float(kCamera + 1.2);
  root_->addChild(camera);
  root_->addChild(lightFrom(-0.4f, 0.7f, 0.6f, 0.8f));
  root_->addChild(lightFrom(0.8f, 0.1f, 0.5f, 0.35f));
  root_->addChild(lightFrom(0, -0.8f, 0.6f, 0.3f));
  auto* material = new SoMaterial;
  material->diffuseColor.setValue(0.72f, 0.36f, 0.30f);
  material->specularColor.setValue(0.15f, 0.15f, 0.15f);
  material->shininess = 0.3f;
  root_->addChild(material);
  root_->addChild(tilt_ = new SoRotation);
  root_->addChild(about_ = new SoRotation);
  // Centred and of radius 1.
  const Aabb box = bounds(mesh);
  const double radius = std::max(0.5 * box.size().norm(), 1e-30);
  TriangleMesh unit = mesh;
  for (Vec3& p : unit.points) p = (p - box.centre()) / radius;
  root_->addChild(makeModel(unit, 60));
  clock_.start();
  draw();
  timer_.start();
}

void SurfaceView::turn() {
  angle_ += kTurn * 1e-3 * double(clock_.restart());
  draw();
  timer_.start();
}

void SurfaceView::draw() {
  about_->rotation.setValue(SbVec3f(0, 1, 0), float(angle_));
  tilt_->rotation.setValue(SbVec3f(1, 0, 0), float(slope_));
  const RgbImage image = view_->render(root_);
  picture_ =
      QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888)
          .copy();
  ++pictures_;
  update();
}

void SurfaceView::paintEvent(QPaintEvent*) {
  if (picture_.isNull()) return;
  QPainter painter(this);
  painter.drawImage(rect(), picture_);
  // Where the patient's directions point, as radiologists mark them; those away from the viewer are
  // darker.
  const std::pair<const char*, SbVec3f> directions[] = {{"L", {1, 0, 0}}, {"R", {-1, 0, 0}},
                                                        {"A", {0, 1, 0}}, {"P", {0, -1, 0}},
                                                        {"F", {0, 0, 1}}, {"H", {0, 0, -1}}};
  for (const auto& [letter, direction] : directions) {
    SbVec3f turned;
    about_->rotation.getValue().multVec(direction, turned);
    tilt_->rotation.getValue().multVec(turned, turned);
    const double radius = 0.45 * kSide;
    const QPointF at(0.5 * kSide + radius * turned[0], 0.5 * kSide - radius * turned[1]);
    const int bright = turned[2] > -0.1f ? 220 : 110;
    painter.setPen(QColor(bright, bright, bright));
    painter.drawText(QRectF(at - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter, letter);
  }
}

void SurfaceView::mousePressEvent(QMouseEvent* event) {
  grabbed_ = event->pos();
  timer_.stop();  // it stays as the hand turns it
}

void SurfaceView::mouseMoveEvent(QMouseEvent* event) {
  if (!root_ || !(event->buttons() & Qt::LeftButton)) return;
  const QPoint moved = event->pos() - grabbed_;
  grabbed_ = event->pos();
  angle_ += kPerPixel * moved.x();
  slope_ = std::clamp(slope_ + kPerPixel * moved.y(), -1.5, 1.5);
  draw();
}

}  // namespace resect

// A small picture of a closed or open surface. The surface turns about the vertical, so that a
// person sees what a file holds before the file becomes an organ. The person can also turn the
// surface by dragging with the mouse.
#pragma once

#include <Inventor/nodes/SoRotation.h>
#include <Inventor/nodes/SoSeparator.h>

#include <QElapsedTimer>
#include <QPoint>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "geometry/triangle_mesh.h"
#include "inventor/picture/offscreen_view.h"

namespace resect {

class SurfaceView : public QWidget {
 public:
  static constexpr int kSide = 300;  // pixels

  explicit SurfaceView(QWidget* parent = nullptr);
  ~SurfaceView() override;

  // mesh: coordinates along the room's axes, in any unit. +X points to the patient's left, +Y to
  // the front, +Z to the feet. In the picture +Y points up, and +Z points towards the viewer at
  // first. Throws Error if OpenGL is missing.
  void setSurface(const TriangleMesh& mesh);
  int pictures() const { return pictures_; }  // number of pictures drawn so far

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  void turn();
  void draw();

  std::unique_ptr<OffscreenView> view_;
  SoSeparator* root_ = nullptr;
  SoRotation *about_ = nullptr, *tilt_ = nullptr;
  QImage picture_;
  QTimer timer_;
  QElapsedTimer clock_;
  QPoint grabbed_;
  // angle_: turn about the vertical, rad. slope_: tilt towards the viewer, rad.
  double angle_ = 0, slope_ = 0.25;
  int pictures_ = 0;
};

}  // namespace resect

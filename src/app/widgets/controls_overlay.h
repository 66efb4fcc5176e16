// Overlay that lists the mouse and keyboard controls. It appears when the program is started for
// the first time, and when F1 is pressed.
#pragma once

#include <QWidget>

namespace resect {

class ControlsOverlay : public QWidget {
 public:
  explicit ControlsOverlay(QWidget* parent);
  // True: lists the controls with which instruments follow the surface. False: lists the controls
  // of the program of the diploma thesis that Resect continues.
  bool guided = true;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
};

}  // namespace resect

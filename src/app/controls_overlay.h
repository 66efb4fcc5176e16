// Overlay with the mouse and keyboard controls, shown at the first start and on F1.
#pragma once

#include <QWidget>

namespace resect {

class ControlsOverlay : public QWidget {
 public:
  explicit ControlsOverlay(QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
};

}  // namespace resect

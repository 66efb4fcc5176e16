// An error message over the picture. It disappears by itself when it is no longer true.
#pragma once

#include <QFrame>
#include <functional>

class QLabel;

namespace resect {

class Banner : public QFrame {
 public:
  explicit Banner(QWidget* parent);
  // Shows the sentence until the user closes it or holds() is false. Without holds(), the sentence
  // disappears 8 s after the first call of userWentOn().
  void say(const QString& sentence, std::function<bool()> holds = {});
  void userWentOn();  // to be called when the user gave input outside the banner
  // Hides the banner if its time is over. Returns whether this call hid the banner.
  bool leaves();
  // Places the banner at the top of this area of the parent, as wide as its sentence needs.
  void place(const QRect& area);

 protected:
  void mousePressEvent(QMouseEvent* event) override;

 private:
  QLabel* sentence_;
  std::function<bool()> holds_;
  qint64 wentOn_ = 0;  // first userWentOn() after say(), ms since 1970; 0: none yet
};

}  // namespace resect

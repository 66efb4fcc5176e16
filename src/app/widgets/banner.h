// A sentence over the picture about what went wrong. It leaves by itself when it holds no more.
#pragma once

#include <QFrame>
#include <functional>

class QLabel;

namespace resect {

class Banner : public QFrame {
 public:
  explicit Banner(QWidget* parent);
  // Shows the sentence until the user closes it or holds() is false. Without holds(): until the
  // user has gone on for some seconds.
  void say(const QString& sentence, std::function<bool()> holds = {});
  void userWentOn();  // there was input elsewhere
  // Hides the banner if its time is over; returns whether it has been hidden now.
  bool leaves();
  // As wide as its sentence needs, at the top of this area of the parent.
  void place(const QRect& area);

 protected:
  void mousePressEvent(QMouseEvent* event) override;

 private:
  QLabel* sentence_;
  std::function<bool()> holds_;
  qint64 wentOn_ = 0;  // when the user went on, ms since 1970; 0: not yet
};

}  // namespace resect

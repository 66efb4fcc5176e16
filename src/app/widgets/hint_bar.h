// The bar over the picture, which says what to do next. It has a button that shows the exercises,
// and a button that makes a slow simulation faster.
#pragma once

#include <QWidget>
#include <functional>

class QLabel;
class QPushButton;

namespace resect {

class HintBar : public QWidget {
 public:
  explicit HintBar(QWidget* parent = nullptr);
  void say(const QString& sentence);
  // Reserves room for this number of lines, so that longer sentences do not move the picture.
  void reserve(int lines);
  // Offers to start the operation again with larger cells. millimetres: side of a cell, mm; 0: no
  // offer.
  void offerCells(int millimetres);
  int offered() const { return offered_; }
  QPoint buttonPlace() const;  // centre of the offer's button, in pixels of the screen

  std::function<void(int millimetres)> accepted;  // the offer's button was pressed
  std::function<void()> exercisesWanted;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void keepHeight();
  int heightOf(int lines) const;  // pixels

  QPushButton* exercises_;
  QLabel* sentence_;
  QPushButton* mend_;
  // offered_: the offered side of the cells, mm; 0: nothing is offered. height_: room for the
  // sentence, pixels. fewest_: the least number of lines; most sentences fit into two lines.
  int offered_ = 0, height_ = 0, fewest_ = 2;
};

}  // namespace resect

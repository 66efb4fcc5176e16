// One line over the picture that says what to do next, a button for the exercises, and one that
// mends slow settings.
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
  // From now on there is room for so many lines, so that longer sentences do not move the picture.
  void reserve(int lines);
  // Offers to begin again with cells of this side, mm; 0: nothing is offered.
  void offerCells(int millimetres);
  int offered() const { return offered_; }
  QPoint buttonPlace() const;  // of the offer, in pixels of the screen

  std::function<void(int millimetres)> accepted;  // the offer's button was pressed
  std::function<void()> exercisesWanted;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void keepHeight();

  QPushButton* exercises_;
  QLabel* sentence_;
  QPushButton* mend_;
  int offered_ = 0, lines_ = 1, fewest_ = 2;  // most sentences need no more beside the buttons
};

}  // namespace resect

// A page over the whole window that shows the exercises as cards. A card says what its exercise
// teaches, shows the learner's best result, and has a button that starts the exercise.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "app/exercise/exercise_list.h"
#include "skills/class/history.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QScrollArea;

namespace resect {

class ExercisesPage : public QWidget {
 public:
  explicit ExercisesPage(QWidget* parent);

  // Fills the page and its cards. done: the learner's scored attempts. folder: path of the folder
  // of attempts.
  void show(const std::vector<Exercise>& exercises, const std::vector<HistoryEntry>& done,
            const QStringList& learners, const QString& learner, const QString& folder);
  QString learner() const;
  bool asTest() const;  // whether exercises begin as graded tests, without undo
  // Shows a sentence about work in progress; empty: no work is in progress.
  void say(const QString& sentence);

  std::function<void(const Exercise&, TaskLevel)> started;
  std::function<void(const Exercise&)> aboutWanted;
  std::function<void()> learnerChosen, closed, folderWanted, addWanted, makeWanted;
  std::function<void(bool names)> classWanted;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QWidget* makeCard(const Exercise& exercise, const std::vector<HistoryEntry>& done);
  void placeCards();

  QComboBox* learner_;
  QCheckBox* test_;
  QLabel *folder_, *said_;
  QScrollArea* scroll_;
  QWidget* inside_;
  QGridLayout* grid_;
  std::vector<QWidget*> cards_;
  int columns_ = 0;
};

}  // namespace resect

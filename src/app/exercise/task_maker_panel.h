// The teacher's panel: an exercise is made from what is on the screen. What is marked on the organ
// is kept by the window.
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <vector>

#include "operation/scenario.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace resect {

class TaskMakerPanel : public QWidget {
 public:
  explicit TaskMakerPanel(QWidget* parent = nullptr);

  // For an operation: its instruments, by model; its structures; whether organs have vessels.
  void begin(const std::vector<std::string>& instruments,
             const std::vector<std::string>& structures, bool vessels);
  // How many places are marked, and whether a click marks one.
  void setMarks(std::size_t marks, bool marking);

  TaskGoal::Kind kind() const;
  // How many places its goal takes: at least, at most.
  std::pair<std::size_t, std::size_t> placesWanted() const;
  bool marksStructure() const;     // a new one is marked, instead of one that the organ has
  double structureRadius() const;  // m
  double structureDepth() const;   // m: of its middle under the surface
  // What the fields say; the goal's places, normal and vessel, and bands are left to the window.
  Task task() const;
  std::string title() const;

  // Lists a try at the exercise. Those that are checked are the reference. good: it is checked.
  void addTry(const QString& words, bool good);
  void clearTries();
  std::vector<std::size_t> references() const;  // numbers of the checked tries, in order
  bool bandWanted() const;                      // a pass takes figures like those of the references

  std::function<void(bool)> markingWanted;
  std::function<void()> goalChanged, lastMarkRemoved, tried, saved, closed;

 private:
  QDoubleSpinBox* number(const char* name, const char* tip, double least, double most, double value,
                         const char* unit, int digits);
  struct Limit {
    const char* measure;
    std::array<QDoubleSpinBox*, 3> fields;  // per level
    QWidget* row;
  };
  Limit limit(const char* name, const char* measure, const char* tip, double most, const char* unit,
              int digits, std::array<double, 3> values);
  void addTries();
  void addButtons();
  void showFields();
  void takeLimits(const Limit& limit, Task& task) const;

  QFormLayout* form_;
  QLineEdit *title_, *teaches_;
  QComboBox *kind_, *structure_;
  QLabel* advice_;
  QPushButton *mark_, *remove_, *try_, *save_;
  QPlainTextEdit* steps_;
  QDoubleSpinBox *within_, *hold_, *size_, *depth_, *margin_;
  std::vector<Limit> limits_;
  QCheckBox *guidance_, *undo_, *band_;
  QLabel* triesAdvice_;
  QListWidget* tries_;
  QWidget* instruments_;
  std::vector<QCheckBox*> boxes_;
  bool vessels_ = false;
  std::size_t marks_ = 0;
};

}  // namespace resect

// The teacher's panel, which makes an exercise out of the operation on the screen. The window, not
// the panel, keeps the marks that the teacher makes on the organ.
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

  // Fills the fields for an operation. instruments: names of the instruments' models. structures:
  // names of the structures in the organs. vessels: whether any organ has vessels.
  void begin(const std::vector<std::string>& instruments,
             const std::vector<std::string>& structures, bool vessels);
  // marks: number of marked places. marking: whether a click now marks a place.
  void setMarks(std::size_t marks, bool marking);

  TaskGoal::Kind kind() const;
  // The least and the largest number of places that the goal needs.
  std::pair<std::size_t, std::size_t> placesWanted() const;
  // True: the teacher marks a new tumour. False: the teacher chooses a structure of the organs.
  bool marksStructure() const;
  double structureRadius() const;  // m, of the new tumour
  double structureDepth() const;   // m, of the new tumour's centre
  // The task from the panel's fields. The window adds the places, the surface normal and the vessel
  // of the goal, and the bands within which the figures of a passing attempt must lie
  // (skills/score/bands.h).
  Task task() const;
  std::string title() const;

  // Adds one of the teacher's own attempts to the list, with the text `words`. The teacher ticks
  // the attempts that are to be the references. good: whether this attempt is ticked at first.
  void addTry(const QString& words, bool good);
  void clearTries();
  std::vector<std::size_t> references() const;  // indices of the ticked attempts, ascending
  // Whether an attempt passes only with figures near those of the references.
  bool bandWanted() const;

  std::function<void(bool)> markingWanted;
  std::function<void()> goalChanged, lastMarkRemoved, tried, saved, closed;

 private:
  QDoubleSpinBox* number(const QString& name, const QString& tip, double least, double most,
                         double value, const char* unit, int digits);
  struct Limit {
    const char* measure;
    std::array<QDoubleSpinBox*, 3> fields;  // one field per level of the exercise
    QWidget* row;
  };
  Limit limit(const QString& name, const char* measure, const QString& tip, double most,
              const char* unit, int digits, std::array<double, 3> values);
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

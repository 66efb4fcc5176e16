// The panel of the operation, in surgical terms: the task, time, blood lost, tissue removed, and
// the force on the instrument in hand.
#pragma once

#include <QLabel>
#include <QWidget>
#include <vector>

#include "operation/live/live_state.h"
#include "operation/scenario.h"

class QFormLayout;

namespace resect {

// The grade of a bleeding on the VIBe scale, in words: "severe (3 of 4)". bleedingRate: m^3/s.
QString gradeText(double bleedingRate);

class OperationPanel : public QWidget {
 public:
  explicit OperationPanel(QWidget* parent = nullptr);
  // To be called when an operation begins. notes: notes from the loading of the operation; they are
  // shown if the scenario has no description, and may be empty. tools: names of the operation's
  // instruments.
  void begin(const Scenario& scenario, const QString& notes, const std::vector<QString>& tools);
  // Whether the panel shows a description or notes.
  bool explains() const { return !task_->text().isEmpty(); }
  // held: number of the tool whose force is shown; -1: none.
  void follow(const LiveState& state, int held);

 private:
  // A line with a name and a value. The line is hidden while it has no value.
  struct Row {
    QLabel *name, *value;
  };
  Row addRow(const QString& name, const QString& tip);
  void set(const Row& row, const QString& value);

  QFormLayout* form_;
  QLabel *title_, *task_;
  Row time_, blood_, bleeding_, grade_, air_, clips_, inflow_, removed_, pieces_, cut_, margin_,
      force_, most_;
  std::vector<QString> tools_;
  double frameRate_ = 60;
};

}  // namespace resect

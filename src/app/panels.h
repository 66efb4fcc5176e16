// The panels beside the picture: instruments, organ, removed tissue, forces, timing.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "app/viewer.h"
#include "operation/live/live_state.h"
#include "operation/scenario.h"
#include "tools/tool.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;
class QToolButton;
class QVBoxLayout;

namespace resect {

// A value over time: pairs of simulated time, s, and value, oldest first.
using History = std::vector<std::pair<double, double>>;

// One button per instrument, pressed while that instrument is in hand.
class InstrumentsPanel : public QWidget {
 public:
  explicit InstrumentsPanel(QWidget* parent = nullptr);
  void setTools(const std::vector<ToolModel>& tools);
  void setHeld(int tool, const QString& how);
  std::function<void(int tool)> chosen;  // -1: puts the tool in hand back
 private:
  QVBoxLayout* layout_;
  QLabel* how_;
  std::vector<QToolButton*> buttons_;
};

// Particles, spacing, volume, iso level.
class OrganPanel : public QWidget {
 public:
  explicit OrganPanel(QWidget* parent = nullptr);
  // spacing: side of the first organ's cells, m.
  void setOrgans(const std::vector<ScenarioOrgan>& organs, double spacing, const QString& notes);
  void follow(const LiveState& state);
  void setIso(float iso);
  void beginAgain();  // restarts with the panel's settings
  std::function<void(float)> isoChanged;
  // spacing: m; none if the user did not change it.
  std::function<void(std::optional<double> spacing, int refine, bool elastic)> rebuild;

 private:
  struct Settings {
    double spacing = 0;  // mm
    int refine = 0;
    bool elastic = false;
    bool operator==(const Settings&) const = default;
  };
  Settings settings() const;
  void sayWhatWaits();

  Settings running_;
  QPushButton* again_;
  QLabel *name_, *counts_, *isoText_, *notes_;
  QSlider* iso_;
  QDoubleSpinBox* spacing_;
  QSpinBox* refine_;
  QCheckBox* elastic_;
};

// Volume of removed tissue, ml, in large digits, with its history.
class RemovedPanel : public QWidget {
 public:
  explicit RemovedPanel(QWidget* parent = nullptr);
  void follow(const LiveState& state);
  void clear();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double removed_ = 0, whole_ = 0;  // m^3
  std::int64_t particles_ = 0;
  History history_;  // ml
};

// The force of the tissue on the tool in hand over the last ten seconds.
class ForcePanel : public QWidget {
 public:
  explicit ForcePanel(QWidget* parent = nullptr);
  void follow(const LiveState& state, int held);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  History history_;  // N
  double peak_ = 0;  // N, since the operation began, on the instrument in hand now or last
};

// Pictures per second, speed against real time, a bar per stage of the step, and advice if drawing
// or simulation is too slow.
class TimingPanel : public QWidget {
 public:
  explicit TimingPanel(QWidget* parent = nullptr);
  void follow(const LiveState& state, const Viewer::Drawing& drawing, double frameRate);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString advice(const StageTime* slowest) const;

  LiveState state_;
  Viewer::Drawing drawing_;
  double frameRate_ = 60;
};

}  // namespace resect

// The panels beside the picture: organ, removed tissue, forces, timing.
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

namespace resect {

// A value over time: pairs of a simulated time, s, and the value at this time. The oldest pair
// comes first.
using History = std::vector<std::pair<double, double>>;

// The organs' names for people: "Built-in liver", "liver, gallbladder".
QString namesOf(const std::vector<ScenarioOrgan>& organs);

// Shows the numbers of particles and triangles and the organ's volume. Lets the user set iso level,
// spacing, refinement and kind of tissue.
class OrganPanel : public QWidget {
 public:
  explicit OrganPanel(QWidget* parent = nullptr);
  // spacing: side of the first organ's cells, m.
  void setOrgans(const std::vector<ScenarioOrgan>& organs, double spacing, const QString& notes);
  void follow(const LiveState& state);
  void setIso(float iso);
  // Whether the panel shows changed settings, which take effect only when beginAgain() is called.
  bool waiting() const { return settings() != running_; }
  // Calls rebuild() with the panel's settings. rebuild() makes new organs without cuts.
  void beginAgain();
  std::function<void(float)> isoChanged;
  // Called by beginAgain(). spacing: m; none if the user did not change it. refine: nodes per cell
  // along each axis.
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

// Shows the volume of removed tissue, ml, in large digits, and below it a plot of this volume over
// time.
class RemovedPanel : public QWidget {
 public:
  explicit RemovedPanel(QWidget* parent = nullptr);
  void follow(const LiveState& state);
  void clear();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString parts_;                   // text: pieces, debris, wounds and margins
  double removed_ = 0, whole_ = 0;  // m^3: removed tissue; all tissue before the operation
  std::int64_t particles_ = 0;
  History history_;  // values in ml
};

// Shows the force of the tissue on the tool in hand over the last ten seconds, and the largest
// force that has acted on any tool so far.
class ForcePanel : public QWidget {
 public:
  explicit ForcePanel(QWidget* parent = nullptr);
  void begin(const std::vector<QString>& tools);  // names of a new operation's tools
  void follow(const LiveState& state, int held);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<QString> tools_;
  History history_;  // values in N
  double peak_ = 0;  // largest force so far, N
  QString reached_;  // name of the tool on which the largest force acted; empty: none
};

// Shows the pictures per second, the simulated time per real time, and a bar for each stage of the
// step. If drawing or simulation is too slow, the panel also gives advice.
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

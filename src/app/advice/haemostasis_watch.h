// Watches a clip applier or bipolar forceps, to tell the user which vessels were closed.
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "operation/live/live_state.h"
#include "tools/tool.h"

namespace resect {

class HaemostasisWatch {
 public:
  // Who works with an instrument.
  enum class Worker { Nobody, Hand, Scenario };
  // Returns the name of the vessel that a segment of an organ belongs to, for people.
  using NameOf = std::function<std::string(std::int32_t organ, std::int32_t segment)>;

  // Whether the tool closes vessels. Only such a tool can be watched.
  static bool watches(const ToolModel& model);
  // tool: its number. model: a model for which watches() is true.
  HaemostasisWatch(int tool, const ToolModel& model);

  // To be called often. Returns the message to show now; empty: none.
  QString follow(const LiveState& state, Worker worker, const NameOf& nameOf);
  // How long bipolar forceps have been closed, in words; empty for other instruments.
  QString howLongClosed(const LiveState& state) const;
  int tool() const { return tool_; }

 private:
  QString followClip(const LiveState& state, bool shuts, const NameOf& nameOf);
  QString followForceps(const LiveState& state, bool shuts, const Vec3& tip, const NameOf& nameOf);

  int tool_;
  bool forceps_;                    // bipolar forceps; else a clip applier
  Vec3 tip_;                        // in the tool's frame, m
  Worker worker_ = Worker::Nobody;  // at the last call
  bool closed_ = false;             // the jaws were closed at the last call
  // Squeeze of the jaws, 0 to 1, at the last call. Empty after the jaws have closed, until they are
  // open again.
  std::optional<double> begun_;
  // The values when the jaws were last open: the clips on vessels, the bleeding ends, and the
  // simulated time, s.
  std::vector<ClippedVessel> clipsBefore_;
  std::vector<BleedingEnd> endsBefore_;
  double opened_ = 0;
  // Simulated time at which a clip was placed, s. -1: no clip remains to be reported.
  double placed_ = -1;
};

}  // namespace resect

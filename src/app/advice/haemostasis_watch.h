// Watches a clip applier or bipolar forceps, to tell the user what they have closed.
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
  // Gives the name of a vessel, for people, by its organ and segment.
  using NameOf = std::function<std::string(std::int32_t organ, std::int32_t segment)>;

  // Whether the tool closes vessels, so that it can be watched.
  static bool watches(const ToolModel& model);
  // tool: its number. model: a model for which watches() is true.
  HaemostasisWatch(int tool, const ToolModel& model);

  // To be called often. Returns what to say now; empty: nothing.
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
  // Last squeeze of the jaws since they were open; empty if they were closed since then.
  std::optional<double> begun_;
  // The clips on vessels, the bleeding ends, and the simulated time, s, when the jaws were last
  // open.
  std::vector<ClippedVessel> clipsBefore_;
  std::vector<BleedingEnd> endsBefore_;
  double opened_ = 0;
  // Simulated time at which a clip was placed whose effect is still to be told, s; -1: none.
  double placed_ = -1;
};

}  // namespace resect

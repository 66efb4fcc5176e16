// Watches the clip applier or the bipolar forceps in hand, to tell the user what they have closed.
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
  // Gives the name of a vessel, for people.
  using NameOf = std::function<std::string(const BleedingEnd&)>;

  // To be called often. Returns what to say now; empty: nothing. held: number of the tool in hand;
  // -1: none. model: its model; null: none.
  QString follow(const LiveState& state, int held, const ToolModel* model, const NameOf& nameOf);
  // How long bipolar forceps have been closed, in words; empty for other instruments.
  QString howLongClosed(const LiveState& state) const;

 private:
  QString followClip(const LiveState& state, bool shuts, const NameOf& nameOf);
  QString followForceps(const LiveState& state, bool shuts, const Vec3& tip, const NameOf& nameOf);

  int held_ = -1;
  bool forceps_ = false;  // the tool in hand is bipolar forceps
  bool closed_ = false;   // its jaws were closed at the last call
  // Last squeeze of its jaws since they were open; empty if they were closed since then.
  std::optional<double> begun_;
  // Number of clips on vessels, the bleeding ends, and the simulated time, s, when the jaws were
  // last open.
  int clipsBefore_ = 0;
  std::vector<BleedingEnd> endsBefore_;
  double opened_ = 0;
  // Simulated time at which a clip was placed whose effect is still to be told, s; -1: none.
  double placed_ = -1;
};

}  // namespace resect

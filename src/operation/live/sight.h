// Whether the user sees the tips of the instruments in hand. The simulation does not know this; the
// window sets it. Recordings keep it as events, since a replay cannot compute it again.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "operation/live/operation_events.h"

namespace resect {

inline constexpr std::string_view kInView = "in_view", kOutOfView = "out_of_view";
inline bool isSight(const OperationEvent& event) {
  return event.kind == kInView || event.kind == kOutOfView;
}

enum class Sight : std::uint8_t { Unknown, Seen, Unseen };

// The events of a frame: one for each tool in hand whose sight is known, if the sight has changed
// or the tool was taken in this frame. sight: one entry per tool; empty: unknown. memory: the sight
// of each tool in the previous frame, which is updated; empty at the start of a branch.
std::vector<OperationEvent> sightEvents(std::span<const Sight> sight, const Simulation& simulation,
                                        std::vector<Sight>& memory);

}  // namespace resect

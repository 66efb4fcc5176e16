// Sight: whether the user sees the tip of an instrument in hand. The window determines the sight.
// Recordings keep its changes as events, since a replay cannot compute them.
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

// The events of a frame. A tool in hand whose sight is known gets an event if its sight has
// changed, or if the tool was taken up in this frame. sight: one entry per tool; if empty, the
// sight of all tools is unknown. memory: the sight of each tool in the previous frame; empty at the
// start of a branch. The function updates `memory`.
std::vector<OperationEvent> sightEvents(std::span<const Sight> sight, const Simulation& simulation,
                                        std::vector<Sight>& memory);

}  // namespace resect

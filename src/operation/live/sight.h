// Whether somebody sees the tips of the instruments in hand. No simulation knows: a window says so,
// and recordings keep it as events, which a replay cannot compute again.
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

// The events of a frame: of each tool in hand whose sight is known and has changed, or that was
// taken in this frame. memory: what was said before, of each tool; empty at the start of a branch.
// sight: per tool; empty: unknown.
std::vector<OperationEvent> sightEvents(std::span<const Sight> sight, const Simulation& simulation,
                                        std::vector<Sight>& memory);

}  // namespace resect

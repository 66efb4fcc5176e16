// The time during which an instrument's tip was outside the picture.
#pragma once

#include <cstdint>
#include <span>

#include "operation/live/operation_events.h"
#include "skills/attempt/attempt.h"

namespace resect {

// Adds up, per instrument, for how long its tip was outside the picture while it was in hand
// (InstrumentRecord::unseen). events: the events of one branch (operation/live/branch.h). Only
// events after frame `first` and up to frame `last` are used.
void addUnseen(std::span<const OperationEvent> events, std::int64_t first, std::int64_t last,
               Attempt& attempt);

}  // namespace resect

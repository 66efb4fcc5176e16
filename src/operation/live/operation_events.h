// The events of a step: contacts that begin and end, tissue removed, cut and torn, instruments
// taken and put back, faults.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/simulation.h"

namespace resect {

struct OperationEvent {
  std::int64_t branch = 0, frame = 0;  // branch: the caller of eventsOf() sets it
  double time = 0;                     // at the frame's end, s
  std::int64_t tool = -1, organ = -1;  // -1: none
  std::string kind;   // touch, release, take, put_back, remove, cut, tear, piece, fault,
                      // smoke, smoke_clears; in_view, out_of_view (sight.h)
  double amount = 0;  // remove: particles; cut, tear: bonds; piece: number of new pieces
  std::string text;   // fault: the sentence
};

// Whether a tool worked on an organ in the step that `report` describes: it touched or pushed
// tissue, cut it, or changed tissue or vessels by another edit. Taking blood away alone does not
// count.
bool worksOnOrgan(const StepReport& report, const Simulation& simulation, std::size_t tool);

// What eventsOf() must know about the step before: one flag per tool, and whether there was smoke.
// Empty lists mean that no tool was in hand, and that none touched an organ.
struct EventMemory {
  std::vector<char> touching, inHand;
  bool smoking = false;
};

// The events of the step that `report` describes; `simulation` is in the state after it.
std::vector<OperationEvent> eventsOf(const StepReport& report, const Simulation& simulation,
                                     EventMemory& memory);

// Updates the memory by an event that was recorded, as eventsOf() did when it happened. tools:
// number of tools.
void remember(EventMemory& memory, const OperationEvent& event, std::size_t tools);

}  // namespace resect

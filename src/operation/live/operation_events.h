// What happened in a step, in words that people and skills use: contacts that begin and end, tissue
// removed, cut and torn, instruments taken and put back, faults.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/simulation.h"

namespace resect {

struct OperationEvent {
  std::int64_t branch = 0, frame = 0;  // the branch is filled in by those who know it
  double time = 0;                     // at the frame's end, s
  std::int64_t tool = -1, organ = -1;  // -1: none
  std::string kind;   // touch, release, take, put_back, remove, cut, tear, piece, fault
  double amount = 0;  // remove: particles; cut, tear: bonds; piece: how many more
  std::string text;   // fault: the sentence
};

// What the observer of an operation remembers from step to step: one flag per tool. Without flags:
// no tool was in hand, and none touched an organ.
struct EventMemory {
  std::vector<char> touching, inHand;
};

// The events of the step that `report` describes; `simulation` is in the state after it.
std::vector<OperationEvent> eventsOf(const StepReport& report, const Simulation& simulation,
                                     EventMemory& memory);

// Notes an event that was kept, as eventsOf() did when it happened. tools: their number.
void remember(EventMemory& memory, const OperationEvent& event, std::size_t tools);

}  // namespace resect

// The events of a step: contacts that begin and end; removal, cutting and tearing of tissue;
// instruments taken and put back; smoke; air in veins; clips that slip; faults.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/simulation.h"

namespace resect {

struct OperationEvent {
  std::int64_t branch = 0, frame = 0;  // branch: the caller of eventsOf() sets it
  double time = 0;                     // simulated time at the frame's end, s
  std::int64_t tool = -1, organ = -1;  // -1: none
  std::string kind;  // touch, release, take, put_back, remove, cut, tear, piece, fault,
                     // smoke, smoke_clears, air, air_stops, clip_slips; in_view, out_of_view
                     // (sight.h)
  // Number of particles (remove), bonds (cut, tear), pieces (piece); flow of air, ml/s (air).
  double amount = 0;
  std::string text;  // fault: the sentence; air, clip_slips: the vessel
};

// Whether a tool worked on an organ in the step that `report` describes: it touched, pushed or cut
// tissue, or it changed tissue or vessels by another edit (organ/edit.h). The edits Release,
// Suction and Press do not count.
bool worksOnOrgan(const StepReport& report, const Simulation& simulation, std::size_t tool);

// The data about the previous step that eventsOf() needs: two flags per tool, and whether there was
// smoke and whether veins drew in air. Empty lists mean that no tool was in hand and no tool
// touched an organ.
struct EventMemory {
  std::vector<char> touching, inHand;
  bool smoking = false, drawsAir = false;
};

// The events of the step that `report` describes. simulation: in the state after this step. Updates
// the memory.
std::vector<OperationEvent> eventsOf(const StepReport& report, const Simulation& simulation,
                                     EventMemory& memory);

// Updates the memory from a recorded event, exactly as eventsOf() did when the event happened.
// tools: number of tools.
void remember(EventMemory& memory, const OperationEvent& event, std::size_t tools);

}  // namespace resect

// Estimates how long the computation of a frame will take, before the first frame is computed.
#pragma once

#include <string>

#include "simulation/simulation.h"

namespace resect {

inline constexpr double kSlowFrame = 2;  // s; slowFrameNote() warns of slower frames

// Estimated time to compute a frame, s: substeps x chunks of cells (TissueChunk) x 380 ns, divided
// by the number of threads. Measured with livers and a kidney of 2 000 to 13 000 particles and with
// a hollow bladder: 320 to 430 ns. Only elastic tissue is counted, since other work cannot be
// estimated from the settings. The estimate is right to about a factor of two. duration:
// simulated time of the frame, s.
double expectedFrameSeconds(const Simulation& simulation, double duration);

// A sentence that compares the estimate with `duration`, the simulated time of the frame, s.
std::string paceNote(const Simulation& simulation, double duration);

// A sentence with the estimate and with settings to change; empty if the estimate is at most
// kSlowFrame.
std::string slowFrameNote(const Simulation& simulation, double duration);

}  // namespace resect

// Estimates how long the computation of a frame will take, before the first frame is computed.
#pragma once

#include <string>

#include "simulation/simulation.h"

namespace resect {

inline constexpr double kSlowFrame = 2;  // s; slowFrameNote() warns if a frame takes longer

// Estimated time to compute a frame, s: substeps x chunks of cells (TissueChunk) x 380 ns, divided
// by the number of threads. The 380 ns are a typical time per substep and chunk: measurements with
// livers and a kidney of 2 000 to 13 000 particles and with a hollow bladder gave 320 to 430 ns.
// Only elastic tissue is counted, since other work cannot be estimated from the settings. The true
// time can be up to about twice the estimate, or down to half of it. duration: simulated time of
// the frame, s.
double expectedFrameSeconds(const Simulation& simulation, double duration);

// A sentence that compares the estimate with `duration`, the simulated time of the frame, s.
std::string paceNote(const Simulation& simulation, double duration);

// A sentence with the estimate and with settings that would make frames faster. Empty if the
// estimate is at most kSlowFrame.
std::string slowFrameNote(const Simulation& simulation, double duration);

}  // namespace resect

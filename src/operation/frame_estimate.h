// How long will a frame take, before the first one is computed?
#pragma once

#include <string>

#include "simulation/simulation.h"

namespace resect {

inline constexpr double kSlowFrame = 2;  // s, beyond which people are told

// Of elastic tissue, the only work whose size follows from the settings: substeps x particles x 20
// ns (docs/methods/tissue.md), over the threads. Right to a factor of three or so. duration: of the
// frame, s.
double expectedFrameSeconds(const Simulation& simulation, double duration);

// A sentence with the estimate and what to change; empty for frames of up to kSlowFrame.
std::string slowFrameNote(const Simulation& simulation, double duration);

}  // namespace resect

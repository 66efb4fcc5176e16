// The rows of the comparison. One function per row, each in a file of its own; built when its
// library is found.
#pragma once

#include "peers/comparison.h"

namespace resect::bench {

Findings rebuildAgainstVtk(const Effort& effort);           // A
Findings rebuildAgainstOpenVdb(const Effort& effort);       // B
Findings updateAgainstVtk(const Effort& effort);            // C
Findings samplingAgainstVtk(const Effort& effort);          // E
Findings samplingAgainstEmbree(const Effort& effort);       // E
Findings contactsAgainstFcl(const Effort& effort);          // F
Findings loadingAgainstCoin(const Effort& effort);          // G
Findings memoryOfStillOrgan(const Effort& effort);          // H
Findings millionParticlesInRealTime(const Effort& effort);  // I

}  // namespace resect::bench

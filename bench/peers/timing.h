// Timing of two implementations in one process, on a machine that may be busy.
//
// Ours, theirs, ours again: if the machine changed meanwhile, our two medians differ and `drift`
// says by how much.
#pragma once

#include <functional>
#include <vector>

#include "peers/comparison.h"

namespace resect::bench {

using Work = std::function<void()>;

double secondsOf(const Work& work);
double median(std::vector<double> values);

// Fills the times, runs and drift of a line. One run of each goes first and does not count, unless
// the peer's takes more than a second.
void timeBoth(const Work& resect, const Work& peer, const Effort& effort, Comparison& line);

// With how many threads a line is measured: 1, and all that the machine has where that is more.
std::vector<int> threadCounts();

}  // namespace resect::bench

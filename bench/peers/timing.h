// How many times faster, in one process on one machine that may be busy with other things?
//
// Ours, theirs, ours again: if the machine changed meanwhile, our two medians differ and `drift`
// says by how much.
#pragma once

#include <functional>

#include "peers/comparison.h"

namespace resect::bench {

using Work = std::function<void()>;

double secondsOf(const Work& work);
double median(std::vector<double> values);

// Fills the times, runs and drift of a line. One run of each goes first and does not count, unless
// the peer's takes more than a second.
void timeBoth(const Work& resect, const Work& peer, const Effort& effort, Comparison& line);

// Keeps the number of threads of Resect and of libraries on TBB while it lives; 0: all.
int threadsOfMachine();

}  // namespace resect::bench

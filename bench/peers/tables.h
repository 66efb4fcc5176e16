// Output of the findings as Markdown, CSV and SVG.
#pragma once

#include <string>

#include "peers/comparison.h"

namespace resect::bench {

std::string machineName();  // model of the processor, threads that it offers

std::string asMarkdown(const Findings& findings);
std::string asCsv(const Findings& findings);  // the comparisons; times in s
std::string figuresAsCsv(const Findings& findings);

// Cost against size on logarithmic axes: a curve per work and library, one thread.
std::string asSvg(const Findings& findings);

}  // namespace resect::bench

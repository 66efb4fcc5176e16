// Standard input, output and error of the program.
#pragma once

#include <cstdio>
#include <filesystem>
#include <initializer_list>

namespace resect {

// To be called first in main(). If one of the three streams is closed, opens /dev/null in its
// place, for reading only, so that printing to the stream fails. Without this, a file that is
// opened later would get the descriptor of the closed stream, and printed text would be written
// into that file.
void openStandardStreams();

// To be called last in main(). Closes standard output. Throws Error if not all of the printed text
// was written.
void finishStandardOutput();

// The stream for text that people read. It is standard error if one of `outputs` goes to standard
// output (isStandardOutput()), so that text and output do not mix. Otherwise it is standard output.
std::FILE* placeForText(std::initializer_list<std::filesystem::path> outputs);

}  // namespace resect

// Standard input, output and error of the program.
#pragma once

#include <cstdio>
#include <filesystem>
#include <initializer_list>

namespace resect {

// To be called first. Where one of the three is closed, no file that is opened later may get its
// number, or what is printed would get into that file: it then leads nowhere, and printing fails.
void openStandardStreams();

// To be called last. Throws Error unless all that was printed has been written.
void finishStandardOutput();

// Where people's text goes: standard output; standard error if one of the outputs is written to
// standard output (isStandardOutput()), which must not be mixed with it.
std::FILE* placeForText(std::initializer_list<std::filesystem::path> outputs);

}  // namespace resect

// What is said about a scenario file that is refused.
#pragma once

#include <string>

#include "io/scenario/scenario_file.h"
#include "support/sentence.h"

namespace resect::test {

// The sentence of the Error; empty when the text is read.
inline std::string complaintOfScenario(const std::string& text,
                                       const std::string& file = "x.toml") {
  return sentenceOf([&] { parseScenario(text, file); });
}

}  // namespace resect::test

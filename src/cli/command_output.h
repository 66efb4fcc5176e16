// Prints the output of a command: JSON, and lines that may contain file names and foreign text.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/text/shown_text.h"

namespace resect {

// Prints exactly one line: line ends and control characters in the arguments are made visible
// (base/text/shown_text.h).
template <typename... Args>
void printLine(std::FILE* file, fmt::format_string<Args...> format, Args&&... args) {
  const std::string line = fmt::format(format, std::forward<Args>(args)...);
  fmt::print(file, "{}\n", shownText(line, kLongestShownPath));
}

inline void printNotes(std::FILE* file, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) printLine(file, "note: {}", shownSentence(note));
}

// Writes the JSON to `target`: the name of a file, or "-" for standard output. Indents by two
// spaces and keeps the order in which keys were added. Characters that are not ASCII become \uXXXX,
// so that a terminal can show them. A file is written atomically (io/output/atomic_file.h).
void writeJson(const std::string& target, const nlohmann::ordered_json& json);

}  // namespace resect

// The measures of an attempt at a task: their names in files, and what they are for people.
//
// docs/methods/skills.md defines each and gives its source; src/skills/ computes them. A task's
// limits and bands refer to them by `id`.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace resect {

struct MeasureKind {
  std::string_view id;     // in files: "path_length_m"
  std::string_view title;  // for people: "path length"
  std::string_view unit;   // "m"; "" for a pure number
  enum class Better { Less, More, Neither } better = Better::Less;
  enum class Of { Whole, Instrument, Both } of = Of::Whole;
};

// All measures, in the order in which reports show them.
std::span<const MeasureKind> measureKinds();
// Null if there is no measure of that name.
const MeasureKind* findMeasure(std::string_view id);
// All names, for messages: "time_s, total_time_s, ...".
std::string measureNames();

}  // namespace resect

// The measures of an attempt at a task: their names in files, and their titles and units for
// people.
//
// docs/methods/skills.md defines each measure and gives its source. src/skills/ computes the
// measures. A task's limits and bands (operation/task/task.h) refer to a measure by its `id`.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace resect {

struct MeasureKind {
  std::string_view id;     // in files: "path_length_m"
  std::string_view title;  // for people: "path length"
  std::string_view unit;   // "m"; "" for a pure number
  // Which values are better.
  enum class Better { Less, More, Neither } better = Better::Less;
  // Whether the measure has a value for the whole attempt, for each instrument, or for both.
  enum class Of { Whole, Instrument, Both } of = Of::Whole;
};

// All measures, in the order in which reports show them.
std::span<const MeasureKind> measureKinds();
// The measure with that `id`; null if there is none.
const MeasureKind* findMeasure(std::string_view id);
// All `id`s, for messages: "time_s, total_time_s, ...".
std::string measureNames();

}  // namespace resect

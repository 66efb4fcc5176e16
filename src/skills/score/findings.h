// What a debrief says about an attempt: for each thing that was not as wanted one fact that the
// recording shows, with its time, one open question, and what to try next; and what was good.
#pragma once

#include <vector>

#include "skills/score/verdict.h"

namespace resect {

// The weightiest first: the goal, then vessels and blood, margin, force, path and time.
std::vector<Deduction> findings(const Attempt& attempt, const GoalResult& goal,
                                const std::vector<Check>& checks);

// Whether the check says that the time for the goal ran out, which is told with the goal and not as
// a fault besides.
bool ranOut(const Check& check, const GoalResult& goal);

// Whether a measure adds up while work goes on, such as time, way and blood: little of it is good
// only if the goal was reached.
bool addsUp(std::string_view measure);

// What was reached, and kept. Little of what adds up while work goes on, such as time, way and
// blood, is good only if the goal was reached; nothing is good of an attempt without any work.
std::vector<std::string> praise(const Attempt& attempt, const GoalResult& goal,
                                const std::vector<Check>& checks);

// "path length 1.25 m"; with few digits, for people.
std::string measureText(std::string_view measure, double value);
// The value of a check as text without its unit, with so many digits that it differs from the
// limit that it breaks; "never" if there is none.
std::string valueText(const Check& check);
// The number alone, as in measureText().
std::string numberText(double value);
// "at most 3 N", "at least 10 mm", "30 to 40 ml".
std::string limitText(const Check& check);
// "1:05.3", minutes and seconds.
std::string timeText(double seconds);

}  // namespace resect

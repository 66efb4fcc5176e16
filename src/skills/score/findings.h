// The statements of a debrief, the report about an attempt. A statement about a fault consists of a
// fact that the recording shows, the time of this fact, an open question, and advice for the next
// attempt. Other statements say what was good.
#pragma once

#include <vector>

#include "skills/score/verdict.h"

namespace resect {

// The faults of an attempt, the most important first: the goal, then vessels and blood, margin,
// force, path and time.
std::vector<Deduction> findings(const Attempt& attempt, const GoalResult& goal,
                                const std::vector<Check>& checks);

// Whether the check says that the time for the goal ran out. Such a check is reported with the
// goal, and not as a fault of its own.
bool ranOut(const Check& check, const GoalResult& goal);

// Whether a measure adds up during the work, such as time, path length and blood loss. If the goal
// was not reached, a low value of such a measure is not praised.
bool addsUp(std::string_view measure);

// Sentences about what was good: the goal, if it was reached; the checks that were kept; and, if
// the task forbids undo, that undo was not used. If the goal was not reached, measures that
// add up (addsUp()) are left out. If the goal was not reached and no instrument was at work, there
// is no praise.
std::vector<std::string> praise(const Attempt& attempt, const GoalResult& goal,
                                const std::vector<Check>& checks);

// A measure for people, with few digits: "path length 1.25 m".
std::string measureText(std::string_view measure, double value);
// The value of a check as text, without the unit. If the value breaks a limit, the text has enough
// digits to differ from the text of that limit. "never" if the check has no value.
std::string valueText(const Check& check);
// The number as measureText() writes it, without name and unit.
std::string numberText(double value);
// The limits of a check as text: "at most 3 N", "at least 10 mm" or "30 to 40 ml".
std::string limitText(const Check& check);
// A time in minutes and seconds: "1:05.3".
std::string timeText(double seconds);

}  // namespace resect

// Makes the rigid bodies that stand round the organs of a scenario. Tissue cannot enter these
// bodies.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "operation/room.h"
#include "operation/scenario.h"
#include "organ/operated_organ.h"
#include "simulation/surroundings.h"

namespace resect {

// In a scenario that shows the operative field (the opened abdomen): the abdominal wall of
// data/room/field_wall.ply, at the place where the wall is drawn. In any other scenario: the walls
// of the tool box, and the table's edge. A body is left out if a particle of an organ lies in this
// body at the start, since the body would push the organ out. If the abdominal wall is left out,
// `notes` says so. The result is empty if no tissue can move.
Surroundings surroundingsOf(const Scenario& scenario, std::span<const OperatedOrgan> organs,
                            std::vector<std::string>* notes = nullptr);

// The abdominal wall at `place`. The function does not test whether tissue lies there.
StandingBody abdominalWall(const FieldPlace& place);

// Recordings of earlier versions do not contain the surroundings. This function gives the
// surroundings with which such recordings are played: the walls of the tool box. The table is
// unbounded. There is no abdominal wall, even if the scenario shows the operative field.
Surroundings surroundingsBefore(const Scenario& scenario, std::span<const OperatedOrgan> organs);

}  // namespace resect

// The bodies that stand round the organs of a scenario and stop moving tissue.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "operation/room.h"
#include "operation/scenario.h"
#include "organ/operated_organ.h"
#include "simulation/surroundings.h"

namespace resect {

// In a scenario that shows the operative field: the abdominal wall of data/room/field_wall.ply, at
// the place where the wall is drawn. In any other scenario: the walls of the tool box, and the
// table's edge. A body is left out if a particle of an organ lies in this body at the start, since
// the body would push the organ out. If the abdominal wall is left out, `notes` says so. The result
// is empty if no tissue can move.
Surroundings surroundingsOf(const Scenario& scenario, std::span<const OperatedOrgan> organs,
                            std::vector<std::string>* notes = nullptr);

// The abdominal wall at a place, even if tissue lies there.
StandingBody abdominalWall(const FieldPlace& place);

// Recordings of earlier versions do not contain the surroundings. They are played with these, in
// every setting: the walls of the tool box, and a table without an end.
Surroundings surroundingsBefore(const Scenario& scenario, std::span<const OperatedOrgan> organs);

}  // namespace resect

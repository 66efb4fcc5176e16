// What stands round the organs of a scenario and stops moving tissue.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "operation/room.h"
#include "operation/scenario.h"
#include "organ/operated_organ.h"
#include "simulation/surroundings.h"

namespace resect {

// In the setting `field`: the abdominal wall, as data/room/field_wall.ply holds it, at the place
// where it is drawn. In other settings: the walls of the scenario's tool box, and the table's edge.
// A body is left out if a particle of some organ lies in it at the start, since it would push that
// organ out. Then the wall gets a note, the tool box none. Empty if no tissue moves.
Surroundings surroundingsOf(const Scenario& scenario, std::span<const OperatedOrgan> organs,
                            std::vector<std::string>* notes = nullptr);

// The abdominal wall at a place, whatever lies there.
StandingBody abdominalWall(const FieldPlace& place);

// What there was before recordings kept it, and with which such recordings are played: in every
// setting the tool box, and a table without an end.
Surroundings surroundingsBefore(const Scenario& scenario, std::span<const OperatedOrgan> organs);

}  // namespace resect

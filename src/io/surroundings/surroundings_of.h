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

// In the setting `field`: the abdominal wall, the stomach and the colon, as data/room/field_*.ply
// holds them, at the place where they are drawn. In other settings: the walls of the scenario's
// tool box, and the table's edge. A body is left out if a particle of some organ lies in it at the
// start, since it would push that organ out; each gets a note, except the tool box. Empty if no
// tissue moves.
Surroundings surroundingsOf(const Scenario& scenario, std::span<const OperatedOrgan> organs,
                            std::vector<std::string>* notes = nullptr);

// The same bodies at a place, whatever lies there.
std::vector<StandingBody> fieldBodies(const FieldPlace& place);

// What there was before recordings kept it, and with which such recordings are played: in every
// setting the tool box, and a table without an end.
Surroundings surroundingsBefore(const Scenario& scenario, std::span<const OperatedOrgan> organs);

}  // namespace resect

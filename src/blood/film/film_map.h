// Makes a map of the thickness of a film of blood, for viewers to draw.
#pragma once

#include <memory>

#include "blood/film/blood_film.h"
#include "surface/tissue_map.h"

namespace resect {

// Cost: the time to clear the map, plus a time proportional to the number of wet cells and their
// neighbours.
std::shared_ptr<const TissueMap> filmMap(const BloodFilm& film, const OperatedOrgan& organ);

}  // namespace resect

// The thickness of a film of blood, as a map that viewers draw.
#pragma once

#include <memory>

#include "blood/film/blood_film.h"
#include "surface/tissue_map.h"

namespace resect {

// Cost: clearing the map, and a term proportional to the number of wet cells and their neighbours.
std::shared_ptr<const TissueMap> filmMap(const BloodFilm& film, const OperatedOrgan& organ);

}  // namespace resect

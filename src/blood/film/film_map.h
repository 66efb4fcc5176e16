// The thickness of a film of blood, as a map that viewers draw.
#pragma once

#include <memory>

#include "blood/film/blood_film.h"
#include "surface/tissue_map.h"

namespace resect {

// Cost: proportional to the number of wet cells and of those beside them, and clearing the map.
std::shared_ptr<const TissueMap> filmMap(const BloodFilm& film, const OperatedOrgan& organ);

}  // namespace resect

// The blood of a film as viewers draw it.
#pragma once

#include <memory>

#include "blood/film/blood_film.h"
#include "surface/tissue_map.h"

namespace resect {

// Cost: the wet cells and those beside them, and clearing the map.
std::shared_ptr<const TissueMap> filmMap(const BloodFilm& film, const OperatedOrgan& organ);

}  // namespace resect

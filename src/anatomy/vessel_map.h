// An organ's anatomy with the index that finds its vessels by place. It never changes; copies of an
// organ share it.
#pragma once

#include <memory>

#include "anatomy/anatomy.h"
#include "anatomy/vessel_index.h"

namespace resect {

struct VesselMap {
  Anatomy anatomy;  // in the tissue at rest
  VesselIndex index;
};

inline std::shared_ptr<const VesselMap> makeVesselMap(Anatomy anatomy) {
  VesselIndex index(anatomy.segments);
  return std::make_shared<const VesselMap>(VesselMap{std::move(anatomy), std::move(index)});
}

}  // namespace resect

// An organ's anatomy with the index that finds its vessels by place. It never changes; copies of an
// organ share it.
#pragma once

#include <memory>
#include <optional>

#include "anatomy/anatomy.h"
#include "anatomy/liver_segments.h"
#include "anatomy/vessel_index.h"

namespace resect {

struct VesselMap {
  Anatomy anatomy;  // in the tissue at rest
  VesselIndex index;
  std::optional<LiverSegments> segments;  // Couinaud's, if the vessels tell them

  // What a vessel is called, by its segment: "right portal vein", or its kind.
  std::string nameOf(std::int32_t segment) const {
    if (segments) return segments->nameOf(anatomy, segment);
    return std::string(resect::nameOf(anatomy.segments[std::size_t(segment)].kind));
  }
};

inline std::shared_ptr<const VesselMap> makeVesselMap(Anatomy anatomy) {
  VesselIndex index(anatomy.segments);
  auto segments = LiverSegments::find(anatomy);
  return std::make_shared<const VesselMap>(
      VesselMap{std::move(anatomy), std::move(index), std::move(segments)});
}

}  // namespace resect

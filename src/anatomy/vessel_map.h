// An organ's anatomy together with the index that finds vessels by position. A VesselMap never
// changes after it was made, so copies of an organ share one VesselMap.
#pragma once

#include <memory>
#include <optional>

#include "anatomy/anatomy.h"
#include "anatomy/liver_segments.h"
#include "anatomy/vessel_index.h"

namespace resect {

struct VesselMap {
  Anatomy anatomy;  // in rest space
  VesselIndex index;
  // Couinaud's segments of the liver; empty if they cannot be found from the vessels.
  std::optional<LiverSegments> segments;

  // The name of the vessel that a segment belongs to, such as "right portal vein". If Couinaud's
  // segments are not known, the result is the name of the vessel's kind.
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

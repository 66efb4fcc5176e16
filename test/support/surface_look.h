// The surface of a tracker with how it looks, in one call.
#pragma once

#include "surface/surface_tracker.h"

namespace resect::test {

inline SurfaceTracker::Compact withLook(SurfaceTracker& tracker, const ColourField& field) {
  tracker.updateLook(field);
  return tracker.compact();
}

// Of a surface made anew.
inline SurfaceTracker::Compact withLook(const ColourField& field, float iso) {
  SurfaceTracker tracker(field, iso);
  return withLook(tracker, field);
}

}  // namespace resect::test

// A check of vessels that have grown.
#pragma once

#include <doctest/doctest.h>

#include "anatomy/measure_anatomy.h"

namespace resect::test {

// No vessel leaves the organ or crosses one of another kind.
inline void checkNoneCrosses(const AnatomyMeasures& m) {
  for (const VesselMeasures& kind : m.kinds) CHECK(kind.outside == 0);
  for (int a = 0; a < kVesselKinds; ++a)
    for (int b = 0; b < a; ++b) {
      CAPTURE(a);
      CAPTURE(b);
      CHECK(m.crossings[std::size_t(a)][std::size_t(b)] == 0);
    }
}

}  // namespace resect::test

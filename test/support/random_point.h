// Random points for tests.
#pragma once

#include "base/random.h"
#include "base/vec.h"

namespace resect::test {

// In the cube of half side `reach` round the origin.
inline Vec3 randomPoint(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

}  // namespace resect::test

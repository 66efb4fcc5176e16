// Meshes, grids and lines that the tests of sampling share.
#pragma once

#include "collision/inside_samples.h"
#include "support/degenerate_mesh.h"

namespace resect {

// n x n columns between `low` and `high`, half a pitch from the ends.
inline ColumnGrid squareGrid(double low, double high, int n) {
  const double pitch = (high - low) / n;
  return {{low + pitch / 2, low + pitch / 2}, {pitch, pitch}, n, n};
}

// A ball of radius 1 that lies along no axis.
inline TriangleMesh turnedBall(int rings) {
  return transformed(sphereMesh({0, 0, 0}, 1, rings),
                     {{0, 0, 0}, Eigen::Quaterniond(0.8, 0.3, 0.2, 0.1).normalized()});
}

// Shells that overlap and touch, up to dozens of crossings a column, with a grid over all of them;
// points on their faces in every third case.
struct SampledShells {
  TriangleMesh mesh;
  ColumnGrid grid;
  SampleLine line, within;  // the second begins and ends within

  SampledShells(Random& random, int k, int mostColumns)
      : mesh(randomDegenerateShells(random, k % 7 + 1)) {
    const int n = 1 + random.below(mostColumns);
    grid = {{0, -0.5}, {8.0 / n, 9.0 / n}, n, n + 3};
    line = {-0.25, k % 3 == 0 ? 0.25 : 8.7 / n, n};
    within = {3, 0.01, n};
  }
};

}  // namespace resect

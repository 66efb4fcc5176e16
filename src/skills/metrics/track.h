// The track of an instrument: its positions at equal intervals of time, during one period in which
// it was in hand or hovered. Each of these positions is a sample.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "base/vec.h"

namespace resect {

struct Track {
  double interval = 1.0 / 60;            // s between samples, > 0
  std::vector<Vec3> tip;                 // world, m
  std::vector<Eigen::Quaterniond> turn;  // rotations of the instrument, unit; empty: not known
  Vec3 axis = Vec3::UnitZ();             // unit, from tip to handle, in the instrument's frame

  double duration() const { return tip.empty() ? 0 : interval * double(tip.size() - 1); }
};

// A range of samples: first, first + 1, ... last.
struct SampleRange {
  std::size_t first = 0, last = 0;
  std::size_t count() const { return last - first + 1; }
};

}  // namespace resect

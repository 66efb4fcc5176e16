// How do numbers over time become a picture? Lines over common axes, as SVG text.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace resect {

struct PlotLine {
  std::string name;
  std::vector<Eigen::Vector2d>
      points;  // in the order in which they are joined; what is not finite is a gap
};

struct LinePlot {
  std::string title, xLabel, yLabel;
  std::vector<PlotLine> lines;
};

// 900 x 360 pixels, readable on light and dark paper. The axes hold all points and y = 0, marked at
// round numbers.
std::string toSvg(const LinePlot& plot);

}  // namespace resect

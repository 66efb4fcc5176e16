// Line plots of numbers over time, as SVG text.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace resect {

struct PlotLine {
  std::string name;
  std::vector<Eigen::Vector2d> points;  // in drawing order; a non-finite value makes a gap
};

struct LinePlot {
  std::string title, xLabel, yLabel;
  std::vector<PlotLine> lines;
};

// 900 x 360 pixels, on a white background. The axes include all finite points and y = 0, with ticks
// at round numbers.
std::string toSvg(const LinePlot& plot);

}  // namespace resect

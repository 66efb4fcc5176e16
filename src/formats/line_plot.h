// Line plots of numbers over time, as SVG text.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace resect {

struct PlotLine {
  std::string name;                     // shown above the plot, in the colour of the line
  std::vector<Eigen::Vector2d> points;  // joined in this order; a non-finite point makes a gap
};

struct LinePlot {
  std::string title, xLabel, yLabel;
  std::vector<PlotLine> lines;
};

// The plot has 900 x 360 pixels and a white background. Its axes cover all finite points and y = 0.
// The ticks of the axes are at round numbers.
std::string toSvg(const LinePlot& plot);

}  // namespace resect

// Charts as inline SVG: curves over time with marks, and paths seen along an axis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace resect {

struct ChartCurve {
  std::string name;
  std::string colour;  // "#b3362b"
  std::vector<Eigen::Vector2d> points;
};

struct ChartMark {
  double time = 0;    // s
  std::string label;  // one or two characters
};

struct TimeChart {
  std::string title, unit;
  double duration = 1;  // of the axis
  std::vector<ChartCurve> curves;
  std::vector<ChartMark> marks;
  std::optional<double> limit;  // drawn as a dashed line
  std::string across = "s";     // unit of the axis
};
// 720 x 170, scales with the page. Long curves are thinned to what can be seen: of the points in a
// column the lowest and the highest.
std::string toSvg(const TimeChart& chart);

struct PathView {
  std::string title;
  int across = 0, up = 1;               // axes of the world, 0 to 2
  bool upDown = false;                  // the vertical axis points down
  std::vector<ChartCurve> curves;       // in the two axes, m
  std::vector<Eigen::Vector2d> places;  // targets, or points of a line, m
  double radius = 0;                    // of a place, m
};
// 300 x 300, both axes to the same scale, with a bar for the scale.
std::string toSvg(const PathView& view);

// Curves and dots in space, which turn about the vertical by themselves, without a script: pictures
// that style.css shows one after the other. On paper, and where motion is not wanted, the first
// one.
struct TurningView {
  std::string title;
  struct Curve {
    std::string colour;
    std::vector<Vec3> points;  // world, m
  };
  std::vector<Curve> curves, dots;
  std::vector<Vec3> balls;  // middles, m
  double radius = 0;        // of a ball, m
};
std::string toSvg(const TurningView& view);

// Colours of instruments and curves, again and again.
std::string chartColour(std::size_t number);

}  // namespace resect

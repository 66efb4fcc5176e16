// Charts as inline SVG: curves over time with marks, and paths seen along an axis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace resect {

struct ChartCurve {
  std::string name;
  std::string colour;  // such as "#b3362b"
  std::vector<Eigen::Vector2d> points;
};

struct ChartMark {
  double time = 0;    // s
  std::string label;  // one or two characters
};

struct TimeChart {
  std::string title, unit;
  double duration = 1;  // the horizontal axis goes from 0 to this value
  std::vector<ChartCurve> curves;
  std::vector<ChartMark> marks;
  std::optional<double> limit;  // drawn as a dashed line
  std::string across = "s";     // unit of the horizontal axis
};
// 720 x 170 pixels, scaled with the page. Long curves are thinned: in each column of pixels only
// the lowest and the highest point are kept.
std::string toSvg(const TimeChart& chart);

struct PathView {
  std::string title;
  int across = 0, up = 1;               // world axes (0 to 2) drawn horizontally and vertically
  bool upDown = false;                  // true: the vertical axis of the picture points down
  std::vector<ChartCurve> curves;       // coordinates along the two axes, m
  std::vector<Eigen::Vector2d> places;  // centres of circles: targets or points of a line, m
  double radius = 0;                    // radius of these circles, m
};
// 300 x 300 pixels, both axes to the same scale, with a scale bar.
std::string toSvg(const PathView& view);

// Curves and dots in space, which rotate about the vertical axis. No script is needed: style.css
// shows several pictures one after the other. On paper, and for readers who prefer reduced motion,
// style.css shows only the first picture.
struct TurningView {
  std::string title;
  struct Curve {
    std::string colour;
    std::vector<Vec3> points;  // world, m
  };
  std::vector<Curve> curves, dots;
  std::vector<Vec3> balls;  // centres, world, m
  double radius = 0;        // radius of a ball, m
};
std::string toSvg(const TurningView& view);

// The colour of the instrument or curve with this number. There are six colours, which repeat.
std::string chartColour(std::size_t number);

}  // namespace resect

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "peers/tables.h"

namespace resect::bench {
namespace {

struct Curve {
  std::string name;
  bool ours = false;
  std::map<double, double> points;  // size, s
};

// One diagram per row and kind of work.
struct Diagram {
  std::string title, sizeUnit;
  Curve resect, peer;
};

constexpr double kWidth = 360, kHeight = 240, kLeft = 58, kTop = 44, kRight = 14, kBottom = 40;

struct Axis {
  int low, high;  // powers of ten
  double from, to;
  double place(double v) const {
    return from + (std::log10(v) - low) / std::max(1, high - low) * (to - from);
  }
};

Axis axisOver(const std::vector<double>& values, double from, double to) {
  const auto [low, high] = std::ranges::minmax(values);
  return {int(std::floor(std::log10(low) + 1e-9)), int(std::ceil(std::log10(high) - 1e-9)), from,
          to};
}

std::string secondsText(int power) {
  static constexpr const char* kNames[] = {"1 us",   "10 us", "100 us", "1 ms", "10 ms",
                                           "100 ms", "1 s",   "10 s",   "100 s"};
  return power >= -6 && power <= 2 ? kNames[power + 6] : fmt::format("1e{} s", power);
}

std::string draw(const Diagram& d, double left, double top) {
  std::vector<double> sizes, times;
  for (const Curve* curve : {&d.resect, &d.peer})
    for (const auto& [size, time] : curve->points) sizes.push_back(size), times.push_back(time);
  const Axis x = axisOver(sizes, left + kLeft, left + kWidth - kRight);
  const Axis y = axisOver(times, top + kHeight - kBottom, top + kTop);
  std::string svg = fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"title\">{}</text>\n",
                                left + 8, top + 18, d.title);
  for (int p = y.low; p <= y.high; ++p) {
    const double at = y.place(std::pow(10, p));
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"grid\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"tick\" text-anchor=\"end\">{}</text>\n",
        x.from, at, x.to, at, x.from - 6, at + 4, secondsText(p));
  }
  for (int p = x.low; p <= x.high; ++p) {
    const double at = x.place(std::pow(10, p));
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"grid\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"tick\" text-anchor=\"middle\">10<tspan "
        "dy=\"-4\" font-size=\"8\">{}</tspan></text>\n",
        at, y.to, at, y.from, at, y.from + 15, p);
  }
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"tick\" text-anchor=\"middle\">{}</text>\n",
      (x.from + x.to) / 2, y.from + 31, d.sizeUnit);
  for (const Curve* curve : {&d.resect, &d.peer}) {
    const char* kind = curve->ours ? "ours" : "peer";
    std::string path;
    for (const auto& [size, time] : curve->points) {
      path +=
          fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.place(size), y.place(time));
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" class=\"{}\"/>\n",
                         x.place(size), y.place(time), kind);
    }
    svg += fmt::format("<path d=\"{}\" class=\"{} line\"/>\n", path, kind);
  }
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"name\"><tspan class=\"ours\">Resect</tspan> <tspan "
      "class=\"peer\" dx=\"8\">{}</tspan></text>\n",
      left + 8, top + 34, d.peer.name);
  return svg;
}

}  // namespace

std::string asSvg(const Findings& findings) {
  std::vector<Diagram> diagrams;
  for (const Comparison& c : findings.comparisons) {
    if (c.threads != 1) continue;
    const std::string title = c.row + ": " + c.work;
    auto d = std::ranges::find_if(
        diagrams, [&](const Diagram& o) { return o.title == title && o.peer.name == c.peer; });
    if (d == diagrams.end()) {
      diagrams.push_back({title, c.sizeUnit, {"Resect", true, {}}, {c.peer, false, {}}});
      d = diagrams.end() - 1;
    }
    d->resect.points[c.size] = c.resect;
    d->peer.points[c.size] = c.peerTime;
  }
  std::erase_if(diagrams, [](const Diagram& d) { return d.resect.points.size() < 2; });
  constexpr int kAcross = 2;
  const int rows = (int(diagrams.size()) + kAcross - 1) / kAcross;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\">\n"
      "<style>.title{{font-size:12px;font-weight:bold}}.tick{{font-size:10px;fill:#555}}"
      ".name{{font-size:10px}}.grid{{stroke:#ddd}}.line{{fill:none;stroke-width:2}}"
      ".ours{{stroke:none;fill:#b3261e}}.peer{{stroke:none;fill:#3b6ea5}}"
      ".ours.line{{fill:none;stroke:#b3261e}}.peer.line{{fill:none;stroke:#3b6ea5}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kAcross * kWidth, rows * kHeight);
  for (std::size_t i = 0; i < diagrams.size(); ++i)
    svg += draw(diagrams[i], double(i % kAcross) * kWidth, double(i / kAcross) * kHeight);
  return svg + "</svg>\n";
}

}  // namespace resect::bench

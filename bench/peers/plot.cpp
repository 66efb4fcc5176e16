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

constexpr double kWidth = 430, kHeight = 240, kLeft = 58, kTop = 44, kRight = 14, kBottom = 40;

constexpr const char *kOurs = "#b3261e", *kPeer = "#3b6ea5";

struct Axis {
  int low, high;  // powers of ten
  double from, to;
  double place(double v) const {
    return from + (std::log10(v) - low) / std::max(1, high - low) * (to - from);
  }
};

Axis axisOver(const std::vector<double>& values, double from, double to) {
  const auto [low, high] = std::ranges::minmax(values);
  return {int(std::floor(std::log10(low) + 0.03)), int(std::ceil(std::log10(high) - 0.03)), from,
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
  std::string svg = fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" font-weight=\"bold\">{}</text>\n", left + 8,
      top + 18, d.title);
  for (int p = y.low; p <= y.high; ++p) {
    const double at = y.place(std::pow(10, p));
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#dddddd\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" fill=\"#555555\" "
        "text-anchor=\"end\">{}</text>\n",
        x.from, at, x.to, at, x.from - 6, at + 4, secondsText(p));
  }
  for (int p = x.low; p <= x.high; ++p) {
    const double at = x.place(std::pow(10, p));
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#dddddd\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" fill=\"#555555\" "
        "text-anchor=\"middle\">1e{}</text>\n",
        at, y.to, at, y.from, at, y.from + 15, p);
  }
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" fill=\"#555555\" "
      "text-anchor=\"middle\">{}</text>\n",
      (x.from + x.to) / 2, y.from + 31, d.sizeUnit);
  for (const Curve* curve : {&d.resect, &d.peer}) {
    const char* colour = curve->ours ? kOurs : kPeer;
    std::string path;
    for (const auto& [size, time] : curve->points) {
      path +=
          fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.place(size), y.place(time));
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n",
                         x.place(size), y.place(time), colour);
    }
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke-width=\"2\" stroke=\"{}\"/>\n", path,
                       colour);
  }
  const auto name = [&](double x, const char* colour, const std::string& text) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" fill=\"{}\">{}</text>\n",
                       x, top + 34, colour, text);
  };
  name(left + 8, kOurs, d.resect.name);
  name(left + 50, kPeer, d.peer.name);
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
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kAcross * kWidth, rows * kHeight);
  for (std::size_t i = 0; i < diagrams.size(); ++i)
    svg += draw(diagrams[i], double(i % kAcross) * kWidth, double(i / kAcross) * kHeight);
  return svg + "</svg>\n";
}

}  // namespace resect::bench

#include "formats/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/shown_text.h"

namespace resect {
namespace {

constexpr double kWidth = 900, kHeight = 360;
constexpr double kLeft = 64, kRight = 20, kTop = 44, kBottom = 48;
constexpr std::array kColours = {"#c8452f", "#2b7fa8", "#3f8f4f", "#8a5fb0", "#b8862b", "#5b6670"};

struct Axis {
  double low = 0, high = 0, step = 1;

  void grow(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // Extends the range to ticks at 1, 2 or 5 times a power of ten, about `marks` of them.
  void roundTo(int marks) {
    if (!(high > low)) high = low + 1;
    const double raw = (high - low) / marks, power = std::pow(10, std::floor(std::log10(raw)));
    step = power * (raw > 5 * power ? 10 : raw > 2 * power ? 5 : raw > power ? 2 : 1);
    low = step * std::floor(low / step);
    high = step * std::ceil(high / step - 1e-9);
  }
};

// For XML, which cannot hold control characters.
std::string escaped(const std::string& foreign) {
  const std::string text = shownText(foreign);
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

}  // namespace

std::string toSvg(const LinePlot& plot) {
  Axis x, y;
  bool first = true;
  for (const PlotLine& line : plot.lines)
    for (const Eigen::Vector2d& p : line.points) {
      if (!p.allFinite()) continue;
      if (first) x.low = x.high = p.x();
      first = false;
      x.grow(p.x());
      y.grow(p.y());
    }
  x.roundTo(10);
  y.roundTo(5);
  const auto across = [&](double v) {
    return kLeft + (v - x.low) / (x.high - x.low) * (kWidth - kLeft - kRight);
  };
  const auto up = [&](double v) {
    return kHeight - kBottom - (v - y.low) / (y.high - y.low) * (kHeight - kTop - kBottom);
  };

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
      "<text x=\"{2:g}\" y=\"22\" font-size=\"15\" font-weight=\"bold\">{3}</text>\n",
      kWidth, kHeight, kLeft, escaped(plot.title));
  for (int k = 0; y.low + k * y.step <= y.high + 1e-9 * y.step; ++k) {
    const double v = y.low + k * y.step, at = up(v);
    svg += fmt::format(
        "<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"{}\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.6g}</text>\n",
        kLeft, at, kWidth - kRight, std::abs(v) < 1e-9 * y.step ? "#333333" : "#dddddd", kLeft - 8,
        at + 4, std::abs(v) < 1e-9 * y.step ? 0 : v);
  }
  for (int k = 0; x.low + k * x.step <= x.high + 1e-9 * x.step; ++k) {
    const double v = x.low + k * x.step;
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.6g}</text>\n",
                       across(v), kHeight - kBottom + 18, std::abs(v) < 1e-9 * x.step ? 0 : v);
  }
  svg += fmt::format(
      "<text x=\"{:g}\" y=\"{:g}\" text-anchor=\"end\">{}</text>\n"
      "<text transform=\"translate(16 {:g}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      kWidth - kRight, kHeight - 10, escaped(plot.xLabel), 0.5 * (kTop + kHeight - kBottom),
      escaped(plot.yLabel));

  double label = kLeft + 10.0 * double(plot.title.size()) + 30;
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const PlotLine& line = plot.lines[i];
    const char* colour = kColours[i % kColours.size()];
    std::string path;
    bool gap = true;
    for (const Eigen::Vector2d& p : line.points) {
      if (p.allFinite())
        path += fmt::format("{}{:.1f} {:.1f}", gap ? "M" : "L", across(p.x()), up(p.y()));
      gap = !p.allFinite();
    }
    if (!path.empty())
      svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n",
                         path, colour);
    svg += fmt::format("<text x=\"{:.0f}\" y=\"22\" fill=\"{}\">{}</text>\n", label, colour,
                       escaped(line.name));
    label += 9.0 * double(line.name.size()) + 18;
  }
  return svg + "</svg>\n";
}

}  // namespace resect

#include "skills/report/chart.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "skills/report/html.h"

namespace resect {
namespace {

constexpr double kWidth = 720, kHeight = 170, kLeft = 44, kRight = 10, kTop = 30, kBottom = 22;
constexpr double kSide = 300, kEdge = 14;

double roundStep(double span, int wanted) {
  const double raw = std::max(span, 1e-12) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double step : {1.0, 2.0, 5.0, 10.0})
    if (step * power >= raw) return step * power;
  return 10 * power;
}

std::string polyline(const std::vector<Eigen::Vector2d>& points, const std::string& colour,
                     double width) {
  std::string at;
  for (const Eigen::Vector2d& p : points) at += fmt::format("{:.1f},{:.1f} ", p.x(), p.y());
  return fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
      "stroke-linejoin=\"round\"/>\n",
      at, colour, width);
}

std::string label(double x, double y, const char* anchor, std::string_view text,
                  const char* colour = "#5d6873") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
                     x, y, anchor, colour, htmlText(text));
}

std::string line(double x0, double y0, double x1, double y1, const char* style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x0, y0,
                     x1, y1, style);
}

// In each column of a pixel the lowest and the highest point.
std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> kept;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i, low = i, high = i;
    for (; end < points.size() && std::floor(points[end].x()) == std::floor(points[i].x()); ++end) {
      if (points[end].y() < points[low].y()) low = end;
      if (points[end].y() > points[high].y()) high = end;
    }
    kept.push_back(points[std::min(low, high)]);
    if (low != high) kept.push_back(points[std::max(low, high)]);
    i = end;
  }
  return kept;
}

// Drops points that are nearer than a pixel to the one before.
std::vector<Eigen::Vector2d> spaced(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> kept;
  for (const Eigen::Vector2d& p : points)
    if (kept.empty() || (p - kept.back()).norm() > 1) kept.push_back(p);
  return kept;
}

struct Span {
  double low = 0, high = 0;
};

// Of all values, 0 and the limit.
Span spanOf(const TimeChart& chart) {
  Span span{0, chart.limit.value_or(0)};
  for (const ChartCurve& curve : chart.curves)
    for (const Eigen::Vector2d& p : curve.points) {
      span.low = std::min(span.low, p.y());
      span.high = std::max(span.high, p.y());
    }
  if (!(span.high > span.low)) span.high = span.low + 1;
  span.high += 0.05 * (span.high - span.low);
  return span;
}

std::string opened(double width, double height, std::string_view title) {
  return fmt::format(
      "<svg viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\" font-size=\"11\" "
      "font-family=\"sans-serif\">\n<title>{2}</title>\n",
      width, height, htmlText(title));
}

std::string legend(const TimeChart& chart) {
  double x = kLeft;
  const std::string title = chart.title + (chart.unit.empty() ? "" : " (" + chart.unit + ")");
  std::string svg = label(x, 12, "start", title, "#1d2329");
  x += 6.2 * double(title.size() + 2);
  for (const ChartCurve& curve : chart.curves) {
    if (curve.name.empty()) continue;
    svg += label(x, 12, "start", curve.name, curve.colour.c_str());
    x += 7.0 * double(curve.name.size() + 2);
  }
  return svg;
}

}  // namespace

std::string chartColour(std::size_t number) {
  // No green: the places of tasks are green.
  constexpr std::array kColours{"#2166a5", "#8a5a00", "#6b3fa0", "#b3362b", "#00767a", "#444c55"};
  return kColours[number % kColours.size()];
}

std::string toSvg(const TimeChart& chart) {
  const Span span = spanOf(chart);
  const double duration = std::max(chart.duration, 1e-3);
  const auto x = [&](double t) { return kLeft + t / duration * (kWidth - kLeft - kRight); };
  const auto y = [&](double v) {
    return kHeight - kBottom - (v - span.low) / (span.high - span.low) * (kHeight - kTop - kBottom);
  };
  constexpr const char* kGrid = "stroke=\"#d7dde3\" stroke-width=\"1\"";
  std::string svg = opened(kWidth, kHeight, chart.title);
  const double stepY = roundStep(span.high - span.low, 3);
  // Attempts, which have no unit, are counted.
  const double stepX = std::max(roundStep(duration, 8), chart.across.empty() ? 1.0 : 0.0);
  for (double v = std::ceil(span.low / stepY) * stepY; v <= span.high; v += stepY)
    svg += line(kLeft, y(v), kWidth - kRight, y(v), kGrid) +
           label(kLeft - 5, y(v) + 4, "end", fmt::format("{:.3g}", std::abs(v) < 1e-9 ? 0 : v));
  for (double t = 0; t <= duration * (1 + 1e-9); t += stepX)
    svg += label(x(t), kHeight - 6, t > 0.97 * duration ? "end" : "middle",
                 fmt::format("{:.3g} {}", t, chart.across));
  if (chart.limit)
    svg += line(kLeft, y(*chart.limit), kWidth - kRight, y(*chart.limit),
                "stroke=\"#b3362b\" stroke-dasharray=\"5 4\"");
  for (const ChartCurve& curve : chart.curves) {
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& p : curve.points) points.emplace_back(x(p.x()), y(p.y()));
    svg += polyline(thinned(points), curve.colour, 1.6);
  }
  double before = -100;
  int row = 0;
  for (const ChartMark& mark : chart.marks) {
    const double at = x(mark.time);
    row = at - before < 14 ? (row + 1) % 3 : 0;
    before = at;
    const double top = kTop - 8 + 13 * row;
    svg += line(at, top + 6, at, kHeight - kBottom, "stroke=\"#b3362b\" stroke-width=\"0.8\"");
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"#b3362b\"/>\n", at, top);
    svg += label(at, top + 4, "middle", mark.label, "#fff");
  }
  return svg + legend(chart) + "</svg>\n";
}

std::string toSvg(const PathView& view) {
  Eigen::AlignedBox2d box;
  for (const ChartCurve& curve : view.curves)
    for (const Eigen::Vector2d& p : curve.points) box.extend(p);
  for (const Eigen::Vector2d& p : view.places) {
    box.extend(Eigen::Vector2d(p.array() - view.radius));
    box.extend(Eigen::Vector2d(p.array() + view.radius));
  }
  std::string svg = opened(kSide, kSide, view.title);
  svg +=
      "<rect x=\"0.5\" y=\"0.5\" width=\"299\" height=\"299\" fill=\"none\" "
      "stroke=\"#d7dde3\"/>\n";
  if (box.isEmpty()) return svg + "</svg>\n";
  const double span = std::max(box.sizes().maxCoeff(), 0.01);
  const double scale = (kSide - 2 * kEdge) / span;
  const Eigen::Vector2d middle = box.center();
  const auto place = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d d = scale * (p - middle);
    return Eigen::Vector2d(kSide / 2 + d.x(), kSide / 2 + (view.upDown ? d.y() : -d.y()));
  };
  for (const Eigen::Vector2d& p : view.places) {
    const Eigen::Vector2d at = place(p);
    svg += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"#1f7a4d\" "
        "fill-opacity=\"0.25\" stroke=\"#1f7a4d\"/>\n",
        at.x(), at.y(), std::max(1.5, scale * view.radius));
  }
  for (const ChartCurve& curve : view.curves) {
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& p : curve.points) points.push_back(place(p));
    svg += polyline(spaced(points), curve.colour, 1.2);
  }
  const double bar = roundStep(span, 4);
  svg += line(kEdge, kSide - 10, kEdge + scale * bar, kSide - 10,
              "stroke=\"#1d2329\" stroke-width=\"2\"");
  svg += label(kEdge + scale * bar + 5, kSide - 6, "start", fmt::format("{:g} mm", 1e3 * bar));
  return svg + "</svg>\n";
}

}  // namespace resect

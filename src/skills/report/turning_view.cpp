// Pictures of curves in space from all sides.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "skills/report/chart.h"
#include "skills/report/html.h"

namespace resect {
namespace {

constexpr int kPictures = 40;  // style.css shows each for 2.5 % of a turn
constexpr double kTurn = 12;   // s
constexpr double kSide = 300, kEdge = 14;
constexpr double kNear = 2.5;  // pixels: points that are nearer to the one before are left out
constexpr std::size_t kMostDots = 700;

// From a little above, turned about the vertical.
Eigen::Vector2d seen(const Vec3& p, double turn) {
  constexpr double kAbove = 20 * std::numbers::pi / 180;
  const double across = std::cos(turn) * p.x() + std::sin(turn) * p.z();
  const double away = std::cos(turn) * p.z() - std::sin(turn) * p.x();
  return {across, -std::cos(kAbove) * p.y() + std::sin(kAbove) * away};
}

struct Frame {
  Vec3 middle = Vec3::Zero();
  double scale = 1;  // pixels per m

  Eigen::Vector2d at(const Vec3& p, double turn) const {
    return Eigen::Vector2d::Constant(kSide / 2) + scale * seen(p - middle, turn);
  }
};

// Round the middle of all there is, so that it fits from every side.
Frame frameOf(const TurningView& view) {
  Eigen::AlignedBox3d box;
  for (const auto* list : {&view.curves, &view.dots})
    for (const TurningView::Curve& curve : *list)
      for (const Vec3& p : curve.points) box.extend(p);
  for (const Vec3& p : view.balls) {
    box.extend(Vec3(p.array() - view.radius));
    box.extend(Vec3(p.array() + view.radius));
  }
  if (box.isEmpty()) return {};
  return {box.center(), (kSide - 2 * kEdge) / std::max(box.diagonal().norm(), 0.01)};
}

std::string curveOf(const TurningView::Curve& curve, const Frame& frame, double turn) {
  std::string points;
  Eigen::Vector2d last = Eigen::Vector2d::Constant(-1e9);
  for (const Vec3& p : curve.points) {
    const Eigen::Vector2d at = frame.at(p, turn);
    if ((at - last).norm() < kNear) continue;
    points += fmt::format("{:.1f},{:.1f} ", at.x(), at.y());
    last = at;
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>\n",
                     points, curve.colour);
}

std::string dotsOf(const TurningView::Curve& dots, const Frame& frame, double turn) {
  std::string path;
  const std::size_t step = 1 + dots.points.size() / kMostDots;
  for (std::size_t i = 0; i < dots.points.size(); i += step) {
    const Eigen::Vector2d at = frame.at(dots.points[i], turn);
    path += fmt::format("M{:.0f} {:.0f}h0", at.x(), at.y());
  }
  return fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"3\" stroke-linecap=\"round\"/>\n",
                     path, dots.colour);
}

}  // namespace

std::string toSvg(const TurningView& view) {
  const Frame frame = frameOf(view);
  std::string svg = fmt::format(
      "<svg class=\"turn\" viewBox=\"0 0 {0} {0}\" role=\"img\" aria-label=\"{1}\">\n"
      "<title>{1}</title>\n",
      kSide, htmlText(view.title));
  for (int i = 0; i < kPictures; ++i) {
    const double turn = 2 * std::numbers::pi * i / kPictures;
    // The picture begins when its share of the turn has come.
    svg += fmt::format("<g style=\"animation-delay:{:.2f}s\">\n", kTurn * i / kPictures - kTurn);
    for (const Vec3& ball : view.balls) {
      const Eigen::Vector2d at = frame.at(ball, turn);
      svg += fmt::format(
          "<circle cx=\"{:.0f}\" cy=\"{:.0f}\" r=\"{:.1f}\" fill=\"#1f7a4d\" "
          "fill-opacity=\"0.25\" stroke=\"#1f7a4d\"/>\n",
          at.x(), at.y(), std::max(1.5, frame.scale * view.radius));
    }
    for (const TurningView::Curve& curve : view.curves) svg += curveOf(curve, frame, turn);
    for (const TurningView::Curve& dots : view.dots)
      if (!dots.points.empty()) svg += dotsOf(dots, frame, turn);
    svg += "</g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace resect

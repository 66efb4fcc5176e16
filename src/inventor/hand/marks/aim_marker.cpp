#include "inventor/hand/marks/aim_marker.h"

#include <cmath>

namespace resect {
namespace {

constexpr double kLift = 0.0015;                                  // m above the surface
constexpr double kRing = 0.0035, kArrow = 0.016, kHead = 0.0035;  // m
constexpr double kDepthPerTick = 0.005;                           // m

// Lines in the plane of the surface: pairs (to the side, forwards), m.
using Line = std::vector<Eigen::Vector2d>;

std::vector<Line> linesOf(double depth) {
  std::vector<Line> lines{
      {{0, kRing}, {0, kArrow}},
      {{-0.6 * kHead, kArrow - kHead}, {0, kArrow}, {0.6 * kHead, kArrow - kHead}}};
  const int ticks = int(std::lround(depth / kDepthPerTick));
  for (int i = 0; i < ticks; ++i) {
    const double y = -kRing - 0.002 - 0.0018 * i;
    lines.push_back({{-0.002, y}, {0.002, y}});
  }
  return lines;
}

}  // namespace

std::vector<MarkLine> aimLines(const SurfaceHand& hand) {
  const Vec3f colour = hand.pressing ? Vec3f(1.0f, 0.72f, 0.25f) : Vec3f(0.75f, 0.95f, 1.0f);
  const Vec3 side = hand.heading.cross(hand.up), foot = workPoint(hand) + kLift * hand.up;
  std::vector<MarkLine> lines{{colour, circle(foot, kRing, hand.up)}};
  for (const Line& line : linesOf(hand.target ? 0 : hand.depth)) {
    MarkLine& to = lines.emplace_back(MarkLine{colour, {}});
    for (const Eigen::Vector2d& p : line)
      to.points.push_back(foot + p.x() * side + p.y() * hand.heading);
  }
  return lines;
}

}  // namespace resect

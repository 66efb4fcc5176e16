#include "inventor/hand/marks/guide_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "anatomy/anatomy.h"

namespace resect {
namespace {

constexpr double kFar = 0.03;  // m: from here on an instrument is not at the goal yet
// Told apart by colour-blind people too: blue, yellow, vermilion.
const Vec3f kNext{1.0f, 0.85f, 0.2f}, kOther{0.55f, 0.68f, 0.75f}, kWell{0.25f, 0.75f, 1.0f},
    kWrong{1.0f, 0.3f, 0.1f};

// Where the plane through p cuts the box: a closed polygon, and lines across it every 2 cm.
std::vector<std::vector<Vec3>> planeLines(const Vec3& p, const Vec3& normal, const Aabb& box) {
  constexpr double kStep = 0.02;
  const Vec3 up = (Vec3::UnitY() - Vec3::UnitY().dot(normal) * normal).norm() > 0.1
                      ? Vec3((Vec3::UnitY() - Vec3::UnitY().dot(normal) * normal).normalized())
                      : normal.unitOrthogonal();
  const Vec3 along = normal.cross(up);
  const Vec3 half = 0.5 * box.size();
  const Vec3 middle = box.centre() - (box.centre() - p).dot(normal) * normal;
  const double wide = along.cwiseAbs().dot(half), high = up.cwiseAbs().dot(half);
  std::vector<std::vector<Vec3>> lines;
  const auto at = [&](double a, double u) { return Vec3(middle + a * along + u * up); };
  lines.push_back(
      {at(-wide, -high), at(wide, -high), at(wide, high), at(-wide, high), at(-wide, -high)});
  for (double a = kStep - wide; a < wide; a += kStep) lines.push_back({at(a, -high), at(a, high)});
  return lines;
}

Vec3f colourOf(Keeping keeping) {
  switch (keeping) {
    case Keeping::Far:
      return kOther;
    case Keeping::Well:
      return kWell;
    case Keeping::Near:
      return kNext;
    case Keeping::Wrong:
      return kWrong;
  }
  return kOther;
}

}  // namespace

std::optional<double> distanceFrom(const Guide& guide, const GuidedTip& tip) {
  using enum Guide::Kind;
  if (guide.places.empty()) return {};
  switch (guide.kind) {
    case Targets:
      if (guide.next >= guide.places.size()) return {};
      return (tip.tip - guide.places[guide.next]).norm();
    case Line: {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i + 1 < guide.places.size(); ++i)
        least = std::min(least,
                         segmentDistance(tip.tip, tip.shaft, guide.places[i], guide.places[i + 1]));
      return least;
    }
    case Plane:
      return std::abs((tip.tip - guide.places[0]).dot(guide.normal));
    case Ball:
      return (tip.tip - guide.places[0]).norm() - guide.radius;
  }
  return {};
}

Keeping keepingOf(const Guide& guide, double distance) {
  if (guide.kind == Guide::Kind::Ball) {
    if (distance <= 0) return Keeping::Wrong;
    if (distance < guide.margin) return Keeping::Near;
    return distance < guide.margin + 0.01 ? Keeping::Well : Keeping::Far;
  }
  if (distance <= guide.radius) return Keeping::Well;
  if (guide.kind == Guide::Kind::Targets || distance > kFar) return Keeping::Far;
  return distance <= 2 * guide.radius ? Keeping::Near : Keeping::Wrong;
}

std::vector<MarkLine> guideLines(const Guide& guide, Keeping keeping, const Vec3& towardsEye) {
  using enum Guide::Kind;
  std::vector<MarkLine> lines;
  const Vec3f colour = colourOf(keeping);
  if (guide.kind == Targets)
    for (std::size_t i = guide.next; i < guide.places.size(); ++i) {
      const bool next = i == guide.next;
      const Vec3f ink = !next ? kOther : keeping == Keeping::Well ? kWell : kNext;
      lines.push_back({ink, circle(guide.places[i], guide.radius, towardsEye)});
      if (next) lines.push_back({ink, circle(guide.places[i], 0.35 * guide.radius, towardsEye)});
    }
  if (guide.kind == Line) lines.push_back({keeping == Keeping::Far ? kNext : colour, guide.places});
  if (guide.kind == Plane)
    for (auto& line : planeLines(guide.places[0], guide.normal, guide.box))
      lines.push_back({colour, std::move(line)});
  if (guide.kind == Ball) {
    lines.push_back({kWrong, circle(guide.places[0], guide.radius, towardsEye)});
    for (const Vec3& axis : {towardsEye, Vec3(Vec3::UnitY())})
      lines.push_back({colour, circle(guide.places[0], guide.radius + guide.margin, axis)});
  }
  return lines;
}

}  // namespace resect

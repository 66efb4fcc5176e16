#include "anatomy/liver_borders.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"

namespace resect {
namespace {

// Settings of the score of a plane.
constexpr double kNearPlane = 0.012;  // m: distance from the plane up to which vessels count
constexpr double kPortal = 0.5;       // weight of portal veins; that of hepatic veins is 1
constexpr double kUnusual = 0.08;     // what is taken off for a share at a bound

// Lumen of the vessels of a kind near the half-plane at an angle, as a share of the lumen of all;
// nearer vessels count more.
double nearPlane(const Anatomy& anatomy, const LiverFrame& frame, VesselKind kind, double angle) {
  const Vec3 out = math::cos(angle) * frame.ahead + math::sin(angle) * frame.left;
  const Vec3 normal = frame.up.cross(out);
  const VesselRange range = anatomy.range(kind);
  double sum = 0, all = 0;
  for (std::int32_t i = range.first; i < range.first + range.count; ++i) {
    const VesselSegment& s = anatomy.segments[std::size_t(i)];
    const double lumen = s.radius * s.radius * s.length();
    const Vec3 way = s.at(0.5) - frame.cava;
    all += lumen;
    if (way.dot(out) > 0) sum += lumen * std::max(0.0, 1 - std::abs(way.dot(normal)) / kNearPlane);
  }
  return sum / all;
}

// The value below which a share of the sorted values lies; there are two or more of them, and at
// least one lies below and one above.
double below(const std::vector<double>& sorted, double share) {
  const double n = double(sorted.size());
  const auto i = std::size_t(std::clamp(share * n + 0.5, 1.0, n - 1));
  return 0.5 * (sorted[i - 1] + sorted[i]);
}

}  // namespace

double bestPlane(const Anatomy& anatomy, const LiverFrame& frame, std::vector<double> angles,
                 const PartShare& share) {
  if (angles.size() < 2) return 0;
  std::ranges::sort(angles);
  constexpr int kTried = 20;  // planes on either side of the usual one
  double best = 0, most = -std::numeric_limits<double>::infinity();
  for (int k = -kTried; k <= kTried; ++k) {
    const double off = double(k) / kTried;
    const double angle = below(angles, share.usual + off * share.off);
    const double score = nearPlane(anatomy, frame, VesselKind::HepaticVein, angle) -
                         kPortal * nearPlane(anatomy, frame, VesselKind::PortalVein, angle) -
                         kUnusual * off * off;
    if (score > most) most = score, best = angle;
  }
  return best;
}

double bestLevel(std::vector<double> heights, const PartShare& share) {
  if (heights.size() < 2) return 0;
  std::ranges::sort(heights);
  return std::clamp(0.0, below(heights, share.usual - share.off),
                    below(heights, share.usual + share.off));
}

}  // namespace resect

#include "anatomy/anatomy.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace resect {
namespace {

constexpr std::string_view kWords[] = {"portal-vein", "hepatic-vein", "hepatic-artery",
                                       "bile-duct"};
constexpr std::string_view kNames[] = {"portal vein", "hepatic vein", "hepatic artery",
                                       "bile duct"};

}  // namespace

std::string_view wordOf(VesselKind kind) { return kWords[std::size_t(kind)]; }
std::string_view nameOf(VesselKind kind) { return kNames[std::size_t(kind)]; }

Anatomy makeAnatomy(std::vector<VesselSegment> segments) {
  Anatomy anatomy;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const VesselSegment& s = segments[i];
    require(s.start.allFinite() && s.end.allFinite() && std::isfinite(s.radius) && s.radius > 0,
            "vessel segment {} has a number that is not finite, or no radius; give finite numbers "
            "and a radius above 0",
            i);
    require(s.parent >= -1 && s.parent < std::int32_t(i),
            "vessel segment {} hangs on segment {}; give one that comes before it, or -1", i,
            s.parent);
    require(s.parent < 0 || segments[std::size_t(s.parent)].kind == s.kind,
            "vessel segment {} and the one that it hangs on are of two kinds; give both the same",
            i);
    VesselRange& range = anatomy.ranges[std::size_t(s.kind)];
    if (range.count == 0) range.first = std::int32_t(i);
    require(range.first + range.count == std::int32_t(i),
            "the segments of the kind {} do not stand together; sort them by kind", wordOf(s.kind));
    ++range.count;
  }
  anatomy.segments = std::move(segments);
  return anatomy;
}

Anatomy transformed(Anatomy anatomy, const Pose& pose) {
  for (VesselSegment& s : anatomy.segments) {
    s.start = pose * s.start;
    s.end = pose * s.end;
  }
  return anatomy;
}

// After Ericson, Real-Time Collision Detection (2005), 5.1.9.
NearestPlaces nearestPlaces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  constexpr double kPoint = 1e-18;  // m^2: shorter than a nanometre
  const Vec3 d1 = q - p, d2 = b - a, r = p - a;
  const double l1 = d1.squaredNorm(), l2 = d2.squaredNorm(), f = d2.dot(r);
  double s = 0, t = 0;
  if (l1 < kPoint && l2 < kPoint) return {};
  if (l1 < kPoint) {
    t = std::clamp(f / l2, 0.0, 1.0);
  } else if (const double c = d1.dot(r); l2 < kPoint) {
    s = std::clamp(-c / l1, 0.0, 1.0);
  } else {
    const double dots = d1.dot(d2), den = l1 * l2 - dots * dots;
    s = den > kPoint * kPoint ? std::clamp((dots * f - c * l2) / den, 0.0, 1.0) : 0;
    t = (dots * s + f) / l2;
    if (t < 0) {
      t = 0;
      s = std::clamp(-c / l1, 0.0, 1.0);
    } else if (t > 1) {
      t = 1;
      s = std::clamp((dots - c) / l1, 0.0, 1.0);
    }
  }
  return {s, t};
}

double segmentDistance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  const NearestPlaces n = nearestPlaces(p, q, a, b);
  return (p + n.first * (q - p) - a - n.second * (b - a)).norm();
}

}  // namespace resect

// The anatomy inside an organ: its vessels, as trees of straight segments in the tissue at rest.
//
// Vessels are far thinner than cells, so cells do not hold them: a segment has its place and its
// radius to the micrometre, whatever the lattice. The order is such that a segment comes after the
// one that feeds it, and that segments of one kind stand together.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/aabb.h"
#include "geometry/pose.h"

namespace resect {

enum class VesselKind : std::uint8_t { PortalVein, HepaticVein, HepaticArtery, BileDuct };
inline constexpr int kVesselKinds = 4;

// Words for the kinds: in files ("portal-vein"), and for people ("portal vein").
std::string_view wordOf(VesselKind kind);
std::string_view nameOf(VesselKind kind);

struct VesselSegment {
  VesselKind kind = VesselKind::PortalVein;
  std::int32_t parent = -1;   // segment at whose end this one begins; -1: it begins at the root
  Vec3 start = Vec3::Zero();  // towards the root, m
  Vec3 end = Vec3::Zero();    // m
  double radius = 0;          // of the lumen, m
  bool leaf = false;          // it ends among the sinusoids

  template <class Visitor>
  void visit(Visitor& v) {
    v("kind", kind), v("parent", parent), v("start", start), v("end", end);
    v("radius", radius), v("leaf", leaf);
  }

  double length() const { return (end - start).norm(); }
  Vec3 at(double share) const { return start + share * (end - start); }  // share: 0 to 1
};

// Range of the segments of a kind.
struct VesselRange {
  std::int32_t first = 0, count = 0;
};

struct Anatomy {
  std::vector<VesselSegment> segments;
  std::array<VesselRange, kVesselKinds> ranges;

  bool empty() const { return segments.empty(); }
  VesselRange range(VesselKind kind) const { return ranges[std::size_t(kind)]; }
};

// Finds the ranges of the kinds. Throws Error unless segments of one kind stand together, each
// parent comes before and has the same kind, and all numbers are finite with radius > 0.
Anatomy makeAnatomy(std::vector<VesselSegment> segments);

// The same anatomy in another place.
Anatomy transformed(Anatomy anatomy, const Pose& pose);

// The nearest places of the segments p-q and a-b, as shares of their lengths.
struct NearestPlaces {
  double first = 0, second = 0;
};
NearestPlaces nearestPlaces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b);
// Distance between these places, m.
double segmentDistance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b);

}  // namespace resect

// The anatomy of an organ: its vessels, as trees of straight segments in rest space.
//
// Vessels are far thinner than the cells of the tissue's lattice, so cells cannot represent them. A
// segment has a position and a radius of its own, which do not depend on the lattice. Segments of
// one kind are stored together, and each segment comes after its parent.
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

// Names of the kinds: wordOf() for files ("portal-vein"), nameOf() for people ("portal vein").
std::string_view wordOf(VesselKind kind);
std::string_view nameOf(VesselKind kind);

struct VesselSegment {
  VesselKind kind = VesselKind::PortalVein;
  std::int32_t parent = -1;   // segment at whose end this one begins; -1: root of a tree
  Vec3 start = Vec3::Zero();  // end on the side of the root, rest space, m
  Vec3 end = Vec3::Zero();    // m
  double radius = 0;          // of the lumen, m
  bool leaf = false;          // whether it ends among the sinusoids; also called a terminal

  template <class Visitor>
  void visit(Visitor& v) {
    v("kind", kind), v("parent", parent), v("start", start), v("end", end);
    v("radius", radius), v("leaf", leaf);
  }

  double length() const { return (end - start).norm(); }
  Vec3 at(double share) const { return start + share * (end - start); }  // share: 0 to 1
};

// The consecutive segments of one kind: their first index and their number.
struct VesselRange {
  std::int32_t first = 0, count = 0;
};

struct Anatomy {
  std::vector<VesselSegment> segments;
  std::array<VesselRange, kVesselKinds> ranges;

  bool empty() const { return segments.empty(); }
  VesselRange range(VesselKind kind) const { return ranges[std::size_t(kind)]; }
};

// Sets the ranges of the kinds. Throws Error unless segments of one kind are stored together, each
// parent comes before its child and has the same kind, and all numbers are finite with radius > 0.
Anatomy makeAnatomy(std::vector<VesselSegment> segments);

// The anatomy with every position transformed by the pose.
Anatomy transformed(Anatomy anatomy, const Pose& pose);

// The points of the segments p-q and a-b that are nearest to each other, as fractions of the
// segments' lengths, 0 to 1: `first` from p to q, `second` from a to b.
struct NearestPlaces {
  double first = 0, second = 0;
};
NearestPlaces nearestPlaces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b);
// Distance between the two nearest points, m.
double segmentDistance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b);

}  // namespace resect

// The anatomy of an organ: its vessels, as trees of straight segments in rest space, that is, at
// their positions before any motion.
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
  // Index of the segment at whose end this segment begins; -1: this segment is the root of a tree.
  std::int32_t parent = -1;
  Vec3 start = Vec3::Zero();  // the end nearer to the root, rest space, m
  Vec3 end = Vec3::Zero();    // the other end, rest space, m
  double radius = 0;          // radius of the lumen, m
  // Whether the segment is at the end of its tree, where the capillaries begin. Such a segment is
  // called a leaf or a terminal.
  bool leaf = false;

  template <class Visitor>
  void visit(Visitor& v) {
    v("kind", kind), v("parent", parent), v("start", start), v("end", end);
    v("radius", radius), v("leaf", leaf);
  }

  double length() const { return (end - start).norm(); }
  Vec3 at(double share) const { return start + share * (end - start); }  // share: 0 to 1
};

// The segments of one kind, which are consecutive. first: index of the first segment. count: number
// of segments.
struct VesselRange {
  std::int32_t first = 0, count = 0;
};

struct Anatomy {
  std::vector<VesselSegment> segments;
  std::array<VesselRange, kVesselKinds> ranges;

  bool empty() const { return segments.empty(); }
  VesselRange range(VesselKind kind) const { return ranges[std::size_t(kind)]; }
};

// Makes an anatomy from segments and sets its ranges. Throws Error in these cases: the segments of
// one kind are not stored together; a parent does not come before its child, or has another kind; a
// number is not finite; a radius is not positive.
Anatomy makeAnatomy(std::vector<VesselSegment> segments);

// The anatomy with every position transformed by the pose.
Anatomy transformed(Anatomy anatomy, const Pose& pose);

// Two points that are nearest to each other: one on the line segment from p to q, the other on the
// line segment from a to b. first: the point on p-q, as a fraction of the way from p to q, 0 to 1.
// second: the point on a-b, as a fraction of the way from a to b, 0 to 1.
struct NearestPlaces {
  double first = 0, second = 0;
};
NearestPlaces nearestPlaces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b);
// The distance between these two points, m.
double segmentDistance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b);

}  // namespace resect

// Axis-aligned boxes, and functions that bound points and intersect boxes.
#pragma once

#include <limits>
#include <span>

#include "base/vec.h"

namespace resect {

// A box that extends from `min` to `max` along each axis, m. Its faces belong to the box. A default
// box is empty, and grow() can extend it.
struct Aabb {
  Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 max = Vec3::Constant(-std::numeric_limits<double>::infinity());

  template <class Visitor>
  void visit(Visitor& v) {
    v("min", min), v("max", max);
  }

  bool empty() const { return (min.array() > max.array()).any(); }
  Vec3 size() const { return empty() ? Vec3(Vec3::Zero()) : Vec3(max - min); }
  Vec3 centre() const { return 0.5 * (min + max); }
  // One of the eight corners. number: 0 to 7. If bit a of `number` is set, the corner is at the
  // upper end of the box along axis a, otherwise at the lower end.
  Vec3 corner(int number) const {
    return {(number & 1 ? max : min).x(), (number & 2 ? max : min).y(),
            (number & 4 ? max : min).z()};
  }
  void grow(const Vec3& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  void grow(const Aabb& box) {
    min = min.cwiseMin(box.min);
    max = max.cwiseMax(box.max);
  }
  Aabb padded(double margin) const {
    return {min - Vec3::Constant(margin), max + Vec3::Constant(margin)};
  }
  bool contains(const Vec3& p) const {
    return (p.array() >= min.array()).all() && (p.array() <= max.array()).all();
  }
};

// Whether the two boxes have a point in common.
inline bool meets(const Aabb& a, const Aabb& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

// The common part of the two boxes. It is empty if the boxes do not meet.
inline Aabb intersection(const Aabb& a, const Aabb& b) {
  return {a.min.cwiseMax(b.min), a.max.cwiseMin(b.max)};
}

inline Aabb bounds(std::span<const Vec3> points) {
  Aabb box;
  for (const Vec3& p : points) box.grow(p);
  return box;
}

}  // namespace resect

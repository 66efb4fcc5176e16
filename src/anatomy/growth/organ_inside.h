// The inside of an organ, for vessels that grow in it: depths below the surface, and a lattice of
// points.
#pragma once

#include <vector>

#include "collision/signed_distance.h"
#include "geometry/triangle_mesh.h"
#include "sph/lattice.h"

namespace resect {

class OrganInside {
 public:
  // surface: closed and oriented outwards. Throws Error if no point of the lattice is at least 3 mm
  // deep.
  explicit OrganInside(const TriangleMesh& surface);

  // Depth below the surface, m; negative outside.
  double depth(const Vec3& p) const { return -distance_(p).distance; }
  // Unit vector towards greater depth; zero where this direction is undefined.
  Vec3 inwards(const Vec3& p) const { return -distance_(p).outwards; }
  // Whether the straight line from a to b is at least `depth`, m, deep everywhere.
  bool deep(const Vec3& a, const Vec3& b, double depth) const;

  // The lattice of points, 5 mm apart; the outermost points lie outside the organ.
  const Lattice& places() const { return places_; }
  // Depth of a point of the lattice, m. place: index of the point.
  double depthAt(std::int64_t place) const { return depths_[std::size_t(place)]; }
  // Searches the points of the lattice that are at least `depth`, m, deep, and returns the point
  // nearest to p. If no point is that deep, returns the deepest point of the lattice.
  Vec3 nearestPlace(const Vec3& p, double depth) const;

 private:
  SignedDistance distance_;
  Lattice places_;
  std::vector<double> depths_;
};

}  // namespace resect

// The inside of an organ, for vessels that grow in it: depth below its surface, and a lattice of
// places.
#pragma once

#include <vector>

#include "collision/signed_distance.h"
#include "geometry/triangle_mesh.h"
#include "sph/lattice.h"

namespace resect {

class OrganInside {
 public:
  // `surface`: closed and oriented outwards. Throws Error if it encloses no place that is 3 mm
  // deep.
  explicit OrganInside(const TriangleMesh& surface);

  // Depth below the surface, m; negative outside.
  double depth(const Vec3& p) const { return -distance_(p).distance; }
  // Unit vector towards greater depth; zero where it is undefined.
  Vec3 inwards(const Vec3& p) const { return -distance_(p).outwards; }
  // Whether the way from a to b is at least `depth` deep all along.
  bool deep(const Vec3& a, const Vec3& b, double depth) const;

  // Places 5 mm apart, with their depths; the outermost are outside.
  const Lattice& places() const { return places_; }
  double depthAt(std::int64_t place) const { return depths_[std::size_t(place)]; }
  // The place nearest to p among those at least `depth` deep; of all places the deepest if none is.
  Vec3 nearestPlace(const Vec3& p, double depth) const;

 private:
  SignedDistance distance_;
  Lattice places_;
  std::vector<double> depths_;
};

}  // namespace resect

#include "operation/live/tip_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace resect {

TipPlace placeOf(const PresentSurface& surface, const Vec3& tip) {
  const auto points = surface.points, normals = surface.normals;
  const Vec3f p = tip.cast<float>();
  float nearest = float(kTipReach * kTipReach), under = 0;
  bool inside = false;
  const auto lookRound = [&](const Triangle& t) {
    if (t[0] == t[1]) return;  // a hole
    for (const std::int32_t v : t) {
      const Vec3f away = p - points[std::size_t(v)];
      if (away.squaredNorm() >= nearest) continue;
      nearest = away.squaredNorm();
      inside = away.dot(normals[std::size_t(v)]) < 0;
    }
  };
  // Intersects the vertical line through the tip with the triangle.
  const auto lookUnder = [&](const Triangle& t) {
    const Vec3f &a = points[std::size_t(t[0])], &b = points[std::size_t(t[1])],
                &c = points[std::size_t(t[2])];
    const auto side = [&](const Vec3f& u, const Vec3f& v) {
      return (v.x() - u.x()) * (p.z() - u.z()) - (v.z() - u.z()) * (p.x() - u.x());
    };
    const float ab = side(a, b), bc = side(b, c), ca = side(c, a), area = ab + bc + ca;
    const bool meets =
        area != 0 && ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0));
    if (!meets) return;
    const float height = (bc * a.y() + ca * b.y() + ab * c.y()) / area;
    if (height <= p.y()) under = std::max(under, height);
  };

  const Organ& organ = surface.organ;
  const double spacing = organ.rest.lattice.spacing.maxCoeff();
  if (surface.moves) {
    // Margin for the sides of triangles in stretched tissue: vertices outside it need no test.
    const float reach = float(kTipReach + 4 * spacing);
    for (const Triangle& t : organ.surface.triangles()) {
      const Vec3f& corner = points[std::size_t(t[0])];
      if (std::abs(corner.x() - p.x()) > reach || std::abs(corner.z() - p.z()) > reach) continue;
      lookRound(t);
      lookUnder(t);
    }
  } else {
    const Vec3 upDown(0, std::numeric_limits<double>::infinity(), 0);
    organ.surface.visitTriangles(organ.field, {tip - upDown, tip + upDown}, lookUnder);
    for (double reach = std::min(2 * spacing, kTipReach);; reach = std::min(2 * reach, kTipReach)) {
      organ.surface.visitTriangles(organ.field, Aabb{tip, tip}.padded(reach), lookRound);
      if (nearest <= reach * reach || reach == kTipReach) break;
    }
  }
  if (inside) return {tip.y(), 0};
  return {under, std::sqrt(double(nearest))};
}

}  // namespace resect

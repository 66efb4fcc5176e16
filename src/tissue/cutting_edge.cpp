#include "tissue/cutting_edge.h"

#include <cmath>

namespace resect {

bool movesToCut(const CuttingEdge& edge) {
  const Vec3 middle = 0.5 * (edge.points.front() + edge.points.back());
  const Vec3 motion = edge.to.rotation.conjugate() * (edge.to * middle - edge.from * middle);
  const double across = motion.dot(edge.normal);
  const Vec3 inPlane = motion - across * edge.normal;
  const Vec3 outwards = (edge.points.back() - edge.points.front()).normalized().cross(edge.normal);
  return inPlane.norm() > std::abs(across) && inPlane.dot(outwards) > -0.5 * inPlane.norm();
}

}  // namespace resect

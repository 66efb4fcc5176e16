#include "organ/builtin/builtin_liver.h"

#include "base/error.h"
#include "isosurface/polygonise.h"
#include "organ/builtin/blended_shape.h"

namespace resect {
namespace {

const BlendedEllipsoid kEllipsoids[] = {
#include "organ/builtin/builtin_liver_shape.inl"
};

const BlendedShape& shape() {
  static const BlendedShape shape(kEllipsoids);
  return shape;
}

}  // namespace

double builtinLiverDistance(const Vec3& p) { return shape()(p); }

TriangleMesh builtinLiver(double edge) {
  require(edge >= 0.0005 && edge <= 0.005,
          "the longest edge of the liver is {} m; give 0.0005 to 0.005", edge);
  const Aabb box{{-0.075, -0.110, -0.102}, {0.132, 0.082, 0.111}};  // a centimetre all around
  return polygonise(builtinLiverDistance, box, {.edge = edge});
}

VesselGrowth builtinLiverVessels() {
  VesselGrowth growth;
  growth.seed = 2;
  growth.hilum = Vec3(0.035, -0.020, 0.010);
  growth.hilumOut = Vec3(0.058, -0.052, 0.012);
  growth.cava = Vec3(0.035, 0.042, -0.016);
  growth.cavaOut = Vec3(0.035, 0.052, -0.034);
  return growth;
}

}  // namespace resect

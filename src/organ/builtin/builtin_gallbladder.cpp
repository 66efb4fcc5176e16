#include "organ/builtin/builtin_gallbladder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "isosurface/polygonise.h"
#include "organ/builtin/blended_shape.h"
#include "organ/builtin/builtin_liver.h"

namespace resect {
namespace {

// Frame of the ellipsoid that carves the fossa (the last one in builtin_liver_shape.inl): z along
// the fossa towards the margin, y into the liver, x to the patient's left.
const Vec3 kFossaCentre(-0.00700, -0.01850, 0.05000);
const Eigen::Vector4d kFossaTurn(0.12864, -0.19553, 0.00000, 0.97223);

// An ellipsoid in the frame of the fossa, given by its long axis, width and height.
struct Piece {
  Vec3 centre, along;                // m; direction of the long axis, any length
  double width, height, halfLength;  // radii, m
  double fillet;                     // m
};

const Piece kPieces[] = {
    // fundus and body
    {{0.0040, -0.0060, 0.0120}, {0, -0.05, 1}, 0.0170, 0.0160, 0.0260, 0.0100},
    // infundibulum, with Hartmann's pouch below
    {{0.0040, -0.0024, -0.0130}, {-0.1, 0, 1}, 0.0100, 0.0095, 0.0200, 0.0180},
    {{0.0040, -0.0080, -0.0280}, {-0.2, 0.2, 1}, 0.0066, 0.0064, 0.0085, 0.0070},
    // neck
    {{0.0080, -0.0055, -0.0370}, {-0.5, 0.1, 1}, 0.0036, 0.0036, 0.0075, 0.0050},
    // cystic duct
    {{0.0135, -0.0085, -0.0425}, {-0.9, 0.7, 0.6}, 0.0022, 0.0022, 0.0075, 0.0030},
    {{0.0180, -0.0145, -0.0450}, {-0.4, 1, 0.3}, 0.0020, 0.0020, 0.0080, 0.0030},
};

constexpr double kGap = 0.0002;        // m, between its wall and the bed
constexpr double kBedFillet = 0.0030;  // m, width over which the wall leaves the bed

BlendedShape pear() {
  const Eigen::Quaterniond fossa = Eigen::Quaterniond(kFossaTurn).normalized();
  std::vector<BlendedEllipsoid> ellipsoids;
  for (const Piece& piece : kPieces) {
    const auto along = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), piece.along);
    ellipsoids.push_back({Blend::Add,
                          kFossaCentre + fossa * piece.centre,
                          (fossa * along).coeffs(),
                          {piece.width, piece.height, piece.halfLength},
                          piece.fillet});
  }
  return BlendedShape(ellipsoids);
}

}  // namespace

double builtinGallbladderDistance(const Vec3& p) {
  static const BlendedShape shape = pear();
  const double free = shape(p), bed = kGap - builtinLiverDistance(p);
  // Smooth maximum of the two, as in BlendedShape.
  const double overlap = std::max(kBedFillet - std::abs(free - bed), 0.0);
  return std::max(free, bed) + overlap * overlap * overlap / (6 * kBedFillet * kBedFillet);
}

TriangleMesh builtinGallbladder(double edge) {
  require(edge >= 0.0005 && edge <= 0.0025,
          "the longest edge of the gallbladder is {} m; give 0.0005 to 0.0025", edge);
  const Aabb box{{-0.050, -0.070, -0.010}, {0.050, 0.020, 0.110}};
  return polygonise(builtinGallbladderDistance, box, {.edge = edge});
}

}  // namespace resect

#include "named_parts.h"

#include <Eigen/Geometry>

namespace fit_liver {

using resect::Blend;
using resect::Mat3;
using resect::Vec3;

std::vector<Part> namedParts() {
  const auto carve = [](const char* name, Vec3 centre, const Mat3& turn, Vec3 radii,
                        double fillet) {
    Part part;
    part.name = name;
    part.ellipsoid = {Blend::Carve, centre, Eigen::Quaterniond(turn).coeffs(), radii, fillet};
    part.smallestRadius = 0.005;
    part.largestRadius = 1.2 * radii.maxCoeff();
    part.home = centre;
    part.leash = 0.008;
    part.smallestFillet = 0.006;
    part.largestFillet = 0.012;
    return part;
  };
  const Mat3 upright = Mat3::Identity();
  const Mat3 alongGallbladder =
      Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(-0.38, -0.25, 0.89))
          .toRotationMatrix();
  std::vector<Part> parts{
      carve("groove of the vena cava", {0.046, 0.005, -0.034}, upright, {0.008, 0.045, 0.022},
            0.008),
      carve("umbilical fissure", {0.048, -0.020, 0.042}, upright, {0.006, 0.022, 0.035}, 0.006),
      carve("gallbladder fossa", {-0.007, -0.0185, 0.050}, alongGallbladder, {0.013, 0.013, 0.044},
            0.008)};
  parts.back().held = true;
  return parts;
}

}  // namespace fit_liver

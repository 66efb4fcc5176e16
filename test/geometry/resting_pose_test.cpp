#include "geometry/resting_pose.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "geometry/primitives.h"

using namespace resect;

TEST_CASE("a tilted box comes to lie on the face that it leans to") {
  const TriangleMesh box = boxMesh({{-2, -0.5, -1}, {2, 0.5, 1}});
  for (double degrees : {-20.0, 5.0, 12.0}) {
    const Pose tilt{Vec3(3, 4, 5),
                    Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180,
                                                         Vec3(1, 0, 2).normalized()))};
    const TriangleMesh held = transformed(box, tilt);
    const TriangleMesh lying = transformed(held, {Vec3::Zero(), restingRotation(held)});
    // As thin as the box's thinnest side, to a tenth of a degree over half a diagonal.
    CHECK(std::abs(bounds(lying).size().y() - 1) < 0.01);
  }
}

TEST_CASE("a body that lies already, and one that encloses nothing, is not turned") {
  CHECK(restingRotation(boxMesh({{0, 0, 0}, {3, 1, 2}}))
            .angularDistance(Eigen::Quaterniond::Identity()) < 2e-3);
  CHECK(restingRotation({}).angularDistance(Eigen::Quaterniond::Identity()) == 0);
}

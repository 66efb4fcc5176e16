#include "organ/builtin/builtin_gallbladder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/measures.h"
#include "geometry/repair/crossings.h"
#include "geometry/topology.h"
#include "organ/builtin/builtin_liver.h"
#include "support/references/nearest_triangle.h"

using namespace resect;

namespace {

// The gallbladder fossa: a point in its middle, where it leads (towards the margin), and the way
// to the left across it, from the ellipsoid that carves it.
const Vec3 kMiddle(-0.007, -0.0185, 0.050);
const Vec3 kAlong = Vec3(-0.380, -0.250, 0.890).normalized();
const Vec3 kAcross = Vec3(0.924, -0.050, 0.380).normalized();

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void grow(double v) { low = std::min(low, v), high = std::max(high, v); }
  double length() const { return high - low; }
};

}  // namespace

TEST_CASE("the built-in gallbladder is one closed piece without handles") {
  for (double edge : {0.0010, 0.0015, 0.0025}) {
    const TriangleMesh mesh = builtinGallbladder(edge);
    const Topology found = topology(mesh);
    CHECK(found.closed());
    CHECK(found.oriented());
    CHECK(found.manifold());
    CHECK(found.components == 1);
    CHECK(int(mesh.points.size()) - int(mesh.triangles.size()) / 2 == 2);  // Euler: genus 0
    // Nothing is cut off at the border of the box it is meshed in.
    for (const Vec3& p : mesh.points) CHECK(std::abs(builtinGallbladderDistance(p)) < 2e-4);
  }
}

TEST_CASE("the built-in gallbladder has an adult's size") {
  const TriangleMesh mesh = builtinGallbladder(0.0025);
  CHECK(volume(mesh) > 30e-6);
  CHECK(volume(mesh) < 50e-6);
  double longest = 0;
  for (const Vec3& a : mesh.points)
    for (const Vec3& b : mesh.points) longest = std::max(longest, (a - b).squaredNorm());
  CHECK(std::sqrt(longest) > 0.07);
  CHECK(std::sqrt(longest) < 0.10);
  // The duct leads to the left; without it the body is as wide as its widest slice.
  Extent width;
  for (const Vec3& p : mesh.points)
    if ((p - kMiddle).dot(kAlong) > 0) width.grow((p - kMiddle).dot(kAcross));
  CHECK(width.length() > 0.03);
  CHECK(width.length() < 0.04);
}

TEST_CASE("the built-in gallbladder is a pear: fundus and body wide, neck narrow, duct thin") {
  const TriangleMesh mesh = builtinGallbladder();
  const auto thickness = [&](double station) {  // across the fossa, m
    Extent width;
    for (const Vec3& p : mesh.points)
      if (std::abs((p - kMiddle).dot(kAlong) - station) < 0.001)
        width.grow((p - kMiddle).dot(kAcross));
    return width.length();
  };
  const double body = thickness(0.012), infundibulum = thickness(-0.020), neck = thickness(-0.038);
  CHECK(body > 1.5 * infundibulum);
  CHECK(infundibulum > 1.4 * neck);
  // The duct leaves the neck to the left and away from the liver.
  Vec3 end = kMiddle;
  for (const Vec3& p : mesh.points)
    if ((p - kMiddle).dot(kAlong) < -0.030 && (p - end).dot(kAcross) > 0) end = p;
  CHECK((end - kMiddle).dot(kAcross) > 0.018);
  CHECK(builtinLiverDistance(end) > 0.005);
}

TEST_CASE("the built-in gallbladder lies on the bed of the liver and does not enter it") {
  const TriangleMesh mesh = builtinGallbladder(), liver = builtinLiver();
  const test::NearestTriangle toLiver(liver, 0.0025);
  Extent contact;
  for (const Vec3& p : mesh.points) {
    CHECK(builtinLiverDistance(p) > -0.001);
    if (toLiver(p).distance < 0.0015) contact.grow((p - kMiddle).dot(kAlong));
  }
  CHECK(contact.length() > 0.04);
  CHECK(contact.length() < 0.06);
  // Everywhere between its ends the bed is touched, not only there.
  for (double station = contact.low; station + 0.004 < contact.high; station += 0.004) {
    double gap = 1;
    for (const Vec3& p : mesh.points)
      if (const double s = (p - kMiddle).dot(kAlong); s >= station && s < station + 0.004)
        gap = std::min(gap, toLiver(p).distance);
    CHECK(gap < 0.0015);
  }
}

TEST_CASE("liver and gallbladder share less than half a millilitre") {
  const TriangleMesh mesh = builtinGallbladder(), liver = builtinLiver();
  const Aabb box = bounds(mesh);
  constexpr double kStep = 0.0015;
  std::vector<Vec3> grid;
  for (double x = box.min.x(); x < box.max.x(); x += kStep)
    for (double y = box.min.y(); y < box.max.y(); y += kStep)
      for (double z = box.min.z(); z < box.max.z(); z += kStep) grid.push_back({x, y, z});
  const std::vector<int> inMesh = crossingNumbers(mesh, grid),
                         inLiver = crossingNumbers(liver, grid);
  int both = 0, mine = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    mine += inMesh[i] == 1;
    both += inMesh[i] == 1 && inLiver[i] == 1;
  }
  const double cell = kStep * kStep * kStep;
  CHECK(mine * cell == doctest::Approx(volume(mesh)).epsilon(0.02));  // the grid sees it
  CHECK(both * cell < 0.5e-6);
}

TEST_CASE("the fundus looks out beyond the margin of the liver, the neck lies under it") {
  const TriangleMesh mesh = builtinGallbladder();
  const Vec3 fundus =
      *std::max_element(mesh.points.begin(), mesh.points.end(),
                        [](const Vec3& a, const Vec3& b) { return a.dot(kAlong) < b.dot(kAlong); });
  const auto liverAbove = [](Vec3 p) {  // along the upright line, m
    for (double h = 0; h < 0.1; h += 0.001)
      if (builtinLiverDistance(p + h * Vec3::UnitY()) < 0) return true;
    return false;
  };
  CHECK(!liverAbove(fundus + 0.001 * kAlong));
  CHECK(liverAbove(fundus - 0.015 * kAlong));  // no more than a centimetre or so
  CHECK(liverAbove(kMiddle - 0.038 * kAlong - Vec3(0, 0.01, 0)));
}

// How near the surface of a label is to the smooth body that was labelled.
#include "formats/labels/label_surface.h"

#include "formats/labels/enclosed_voxels.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "geometry/measures.h"
#include "geometry/topology.h"

using namespace resect;

namespace {

using SolidBody = std::function<double(const Vec3&)>;  // m: below 0 inside

double ballDistance(const Vec3& p) { return p.norm() - 0.04; }

// A flat body as a liver is: an ellipsoid with a flat side.
double halfEllipsoid(const Vec3& p) {
  const Vec3 q = p.cwiseQuotient(Vec3(0.09, 0.06, 0.035));
  const double k = q.norm(),
               slope = q.cwiseQuotient(Vec3(0.09, 0.06, 0.035)).norm() / std::max(k, 1e-9);
  return (k - 1) / std::max(slope, 1 / 0.09);
}

double vessel(const Vec3& p) {  // a bent tube of 8 mm
  const double r = std::hypot(p.x(), p.y()) - 0.05;
  return std::max(std::hypot(r, p.z()) - 0.004, -p.y());
}

// Labels voxels whose centre is inside.
LabelImage labelled(const SolidBody& body, const Vec3& spacing, const Eigen::Quaterniond& turn,
                    const Vec3& reach, double mirror) {
  LabelImage image;
  image.format = "test";
  image.step = turn.toRotationMatrix() * spacing.asDiagonal();
  image.step.col(0) *= mirror;
  image.dims = (2 * reach.cwiseQuotient(spacing)).array().ceil().cast<int>() + 2;
  image.origin = -image.step * (0.5 * image.dims.cast<double>() + Vec3(0.13, -0.21, 0.4));
  image.layers.emplace_back().assign(std::size_t(image.voxelCount()), 0);
  image.labels.push_back({1, "body", 0, 0});
  std::size_t i = 0;
  for (int z = 0; z < image.dims.z(); ++z)
    for (int y = 0; y < image.dims.y(); ++y)
      for (int x = 0; x < image.dims.x(); ++x, ++i)
        if (body(image.origin + image.step * Vec3(x, y, z)) < 0)
          image.layers[0][i] = 1, ++image.labels[0].voxels;
  return image;
}

struct Fit {
  double volume = 0;  // of the surface, by that of the voxels
  // Distance from the body's border, in voxels along their own axes.
  double mean = 0, worst = 0;
  double beyondHalf = 0;  // share of the points that are farther than half a voxel
};

Fit fit(const SolidBody& body, const LabelImage& image) {
  const int chosen[] = {0};
  const TriangleMesh mesh = labelSurface(image, chosen);
  const Topology t = topology(mesh);
  REQUIRE(t.closed());
  REQUIRE(t.oriented());
  REQUIRE(t.components == 1);
  Fit result;
  result.volume = volume(mesh) / (double(image.labels[0].voxels) * image.voxelVolume());
  for (const Vec3& p : mesh.points) {
    const double h = 1e-6;
    Vec3 gradient;
    for (int a = 0; a < 3; ++a)
      gradient[a] = (body(p + h * Vec3::Unit(a)) - body(p - h * Vec3::Unit(a))) / (2 * h);
    const double far = std::abs(body(p)) / (image.step.transpose() * gradient).norm();
    result.mean += far / double(mesh.points.size());
    result.worst = std::max(result.worst, far);
    result.beyondHalf += (far > 0.5 ? 1.0 : 0.0) / double(mesh.points.size());
  }
  return result;
}

const Eigen::Quaterniond kTurn(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()));
const Vec3 kEven(0.001, 0.001, 0.001), kThick(0.0008, 0.0008, 0.005),
    kCoarse(0.0015, 0.0015, 0.003);

}  // namespace

TEST_CASE(
    "the surface of a label lies within half a voxel of the body, in thick and turned slices") {
  struct Named {
    const char* name;
    SolidBody body;
    Vec3 reach;
  };
  for (const Named& one : {Named{"ball", ballDistance, Vec3::Constant(0.045)},
                           Named{"half ellipsoid", halfEllipsoid, Vec3::Constant(0.095)}})
    for (const Vec3& spacing : {kEven, kThick, kCoarse})
      for (const Eigen::Quaterniond& turn : {Eigen::Quaterniond::Identity(), kTurn})
        for (const double mirror : {1.0, -1.0}) {
          CAPTURE(one.name);
          CAPTURE(spacing.transpose());
          CAPTURE(mirror);
          LabelImage image = labelled(one.body, spacing, turn, one.reach, mirror);
          const Fit found = fit(one.body, image);
          CHECK(found.volume == doctest::Approx(1).epsilon(0.001));
          CHECK(found.mean < 0.09);
          CHECK(found.worst < 0.6);
          CHECK(found.beyondHalf < 0.001);
        }
}

TEST_CASE("a vessel that is thin for its voxels stays in one piece and keeps its volume") {
  for (const Vec3& spacing : {kEven, kThick, kCoarse})
    for (const Eigen::Quaterniond& turn : {Eigen::Quaterniond::Identity(), kTurn}) {
      CAPTURE(spacing.transpose());
      const Fit found = fit(vessel, labelled(vessel, spacing, turn, Vec3::Constant(0.06), 1));
      CHECK(found.volume == doctest::Approx(1).epsilon(0.005));
      CHECK(found.mean < 0.2);
    }
}

TEST_CASE("single voxels, and labels at the image's border, give closed surfaces") {
  LabelImage image;
  image.dims = {4, 3, 5};
  image.step = Vec3(0.001, 0.002, 0.003).asDiagonal();
  image.layers.emplace_back().assign(60, 0);
  image.labels = {{1, "", 0, 1}, {2, "", 0, 60}};
  image.layers[0][17] = 1;
  const int first[] = {0}, none[] = {1};
  const TriangleMesh single = labelSurface(image, first);
  CHECK(topology(single).closed());
  CHECK(volume(single) > 0);
  CHECK(labelSurface(image, none).points.empty());
  std::ranges::fill(image.layers[0], std::uint16_t(2));
  const TriangleMesh all = labelSurface(image, none);
  CHECK(topology(all).closed());
  CHECK(volume(all) == doctest::Approx(60 * 6e-9).epsilon(0.01));
}

TEST_CASE("vessels count where they lie within an organ, also through it along an axis") {
  for (const double start : {0.0, -0.07}) {
    CAPTURE(start);
    // From outside into the middle of a ball, or through it.
    const auto tube = [&](const Vec3& p) {
      return std::max(std::hypot(p.y(), p.z()) - 0.004, std::max(start - p.x(), p.x() - 0.07));
    };
    LabelImage image =
        labelled(ballDistance, kEven, Eigen::Quaterniond::Identity(), Vec3::Constant(0.08), 1);
    image.labels.push_back({2, "vein", 0, 0});
    std::size_t i = 0;
    std::int64_t within = 0;
    for (int z = 0; z < image.dims.z(); ++z)
      for (int y = 0; y < image.dims.y(); ++y)
        for (int x = 0; x < image.dims.x(); ++x, ++i) {
          const Vec3 p = image.origin + image.step * Vec3(x, y, z);
          if (tube(p) >= 0) continue;
          within += image.layers[0][i] == 1;
          image.layers[0][i] = 2;
        }
    const int organ[] = {0}, vessels[] = {1};
    const LabelImage filled = withEnclosed(image, organ, vessels);
    const double ml = 1e6 * volume(labelSurface(filled, organ));
    const double whole = 1e6 * double(image.labels[0].voxels) * image.voxelVolume();
    CHECK(within > 1000);
    CHECK(ml == doctest::Approx(whole).epsilon(0.005));
  }
}

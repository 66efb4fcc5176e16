#include "anatomy/thinning/centre_lines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "anatomy/vessel_mesh.h"
#include "base/random.h"
#include "geometry/primitives.h"

using namespace resect;

namespace {

double distanceTo(const VesselSegment& s, const Vec3& p) {
  const Vec3 way = s.end - s.start;
  return (p - s.at(std::clamp((p - s.start).dot(way) / way.squaredNorm(), 0.0, 1.0))).norm();
}

// The tubes round the segments, with round ends.
SolidShape tubes(const std::vector<VesselSegment>& segments, double cell) {
  Aabb box;
  for (const VesselSegment& s : segments)
    for (const Vec3& end : {s.start, s.end}) {
      box.grow(Vec3(end - Vec3::Constant(s.radius + 2 * cell)));
      box.grow(Vec3(end + Vec3::Constant(s.radius + 2 * cell)));
    }
  SolidShape shape;
  shape.lattice.spacing = Vec3::Constant(cell);
  shape.lattice.dims = (box.size() / cell).array().ceil().cast<int>() + 1;
  shape.lattice.origin = box.min;
  shape.depth.assign(std::size_t(shape.lattice.cellCount()), -1);
  for (const VesselSegment& s : segments) {
    Aabb round;
    round.grow(s.start), round.grow(s.end);
    visitCellsIn(shape.lattice, round.padded(s.radius + cell), [&](const Vec3i& at) {
      float& depth = shape.depth[std::size_t(shape.lattice.index(at))];
      depth = std::max(depth, float(s.radius - distanceTo(s, shape.lattice.centre(at))));
    });
  }
  return shape;
}

// A trunk of 4 mm radius that parts into two branches, one of which parts again; turned at random.
std::vector<VesselSegment> tree(Random& random) {
  const auto unit = [&] { return 2 * random.uniform() - 1; };
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(unit(), unit(), unit(), unit() + 1.5).normalized();
  const Vec3 shift(0.01 * unit(), 0.01 * unit(), 0.01 * unit());
  std::vector<VesselSegment> segments{
      {VesselKind::HepaticVein, -1, Vec3(0, 0, 0), Vec3(0.03, 0.004, 0), 0.004, false},
      {VesselKind::HepaticVein, 0, Vec3(0.03, 0.004, 0), Vec3(0.055, 0.022, 0.004), 0.003, false},
      {VesselKind::HepaticVein, 0, Vec3(0.03, 0.004, 0), Vec3(0.052, -0.022, 0.0), 0.0022, true},
      {VesselKind::HepaticVein, 1, Vec3(0.055, 0.022, 0.004), Vec3(0.08, 0.02, 0.02), 0.002, true},
      {VesselKind::HepaticVein, 1, Vec3(0.055, 0.022, 0.004), Vec3(0.06, 0.048, 0), 0.0015, true}};
  for (VesselSegment& s : segments) {
    s.start = turn * s.start + shift;
    s.end = turn * s.end + shift;
  }
  return segments;
}

double lengthOf(const std::vector<VesselSegment>& segments) {
  double sum = 0;
  for (const VesselSegment& s : segments) sum += s.length();
  return sum;
}

}  // namespace

TEST_CASE("centre lines follow the vessels, turned and shifted in the lattice") {
  Random random(7);
  for (int trial = 0; trial < 8; ++trial) {
    CAPTURE(trial);
    const std::vector<VesselSegment> real = tree(random);
    const std::vector<VesselSegment> found =
        centreLines(tubes(real, 0.4e-3), VesselKind::HepaticVein);
    REQUIRE(!found.empty());
    const Anatomy anatomy = makeAnatomy(found);  // parents come first
    CHECK(std::ranges::count(found, true, &VesselSegment::leaf) == 3);
    CHECK(std::ranges::count(found, -1, &VesselSegment::parent) == 1);
    CHECK((found[0].start - real[0].start).norm() < 0.004 + 1e-3);  // a round end is a radius long
    CHECK(lengthOf(found) == doctest::Approx(lengthOf(real) + 0.0).epsilon(0.1));
    for (const VesselSegment& s : found) {
      if (s.parent >= 0) CHECK(s.start == found[std::size_t(s.parent)].end);
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const auto nearest = std::ranges::min_element(real, {}, [&](const VesselSegment& r) {
          return distanceTo(r, s.at(share)) / r.radius;
        });
        // A round end is followed to its wall.
        CHECK(distanceTo(*nearest, s.at(share)) <
              std::max(0.45 * nearest->radius, s.leaf || s.parent < 0 ? nearest->radius : 0));
      }
      const Vec3 middle = s.at(0.5);
      const auto own = std::ranges::min_element(
          real, {}, [&](const VesselSegment& r) { return distanceTo(r, middle); });
      if (s.length() > 2 * own->radius)
        CHECK(s.radius == doctest::Approx(own->radius).epsilon(0.15));
    }
  }
}

TEST_CASE("a surface becomes a solid shape with its volume, and a straight tube one line") {
  const std::vector<VesselSegment> tube{
      {VesselKind::BileDuct, -1, Vec3(0.01, 0.02, 0.03), Vec3(0.05, 0.03, 0.045), 0.003, true}};
  const TriangleMesh mesh = vesselMesh(makeAnatomy(tube), VesselKind::BileDuct);
  const SolidShape shape = solidShape(mesh, 0.5e-3);
  const auto inside = std::ranges::count_if(shape.depth, [](float d) { return d > 0; });
  CHECK(double(inside) * shape.lattice.cellVolume() ==
        doctest::Approx(tube[0].length() * 8 * std::tan(std::numbers::pi / 8) * 0.003 * 0.003)
            .epsilon(0.15));
  const std::vector<VesselSegment> found = centreLines(shape, VesselKind::BileDuct);
  REQUIRE(!found.empty());
  CHECK(std::ranges::count(found, true, &VesselSegment::leaf) == 1);
  CHECK(lengthOf(found) == doctest::Approx(tube[0].length()).epsilon(0.1));
  for (const VesselSegment& s : found) {
    CHECK(distanceTo(tube[0], s.start) < 0.35 * 0.003);
    CHECK(distanceTo(tube[0], s.end) < 0.35 * 0.003);
    CHECK(s.radius == doctest::Approx(0.0028).epsilon(0.15));
  }
}

TEST_CASE("two vessels apart are two trees, and a speck is none") {
  std::vector<VesselSegment> two{
      {VesselKind::PortalVein, -1, Vec3(0, 0, 0), Vec3(0.03, 0, 0), 0.002, true},
      {VesselKind::PortalVein, -1, Vec3(0, 0.02, 0), Vec3(0.03, 0.02, 0), 0.003, true},
      {VesselKind::PortalVein, -1, Vec3(0, 0.04, 0), Vec3(0.0001, 0.04, 0), 0.0004, true}};
  const std::vector<VesselSegment> found = centreLines(tubes(two, 0.5e-3), VesselKind::PortalVein);
  CHECK(std::ranges::count(found, -1, &VesselSegment::parent) == 2);
  CHECK(std::ranges::count(found, true, &VesselSegment::leaf) == 2);
  CHECK(centreLines(SolidShape(), VesselKind::PortalVein).empty());
}

TEST_CASE("hepatic veins begin where they come together, however wide their other ends are") {
  Random random(3);
  const auto unit = [&] { return 2 * random.uniform() - 1; };
  for (int trial = 0; trial < 4; ++trial) {
    CAPTURE(trial);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(unit(), unit(), unit(), unit() + 1.5).normalized();
    const Vec3 meeting = 0.01 * Vec3(unit(), unit(), unit());
    // Each widens away from the meeting place; they end 6 mm from it. A short piece lies apart.
    std::vector<VesselSegment> veins;
    for (const Vec3& way : {Vec3(1, 0.2, 0), Vec3(0.1, 1, 0.3), Vec3(-0.9, 0.3, 0.4)}) {
      const Vec3 along = turn * way.normalized(), start = meeting + 0.006 * along;
      veins.push_back({VesselKind::HepaticVein, -1, start, start + 0.02 * along, 0.0015, false});
      veins.push_back(
          {VesselKind::HepaticVein, -1, start + 0.02 * along, start + 0.05 * along, 0.0025, true});
    }
    const Vec3 apart = meeting + turn * Vec3(0.03, -0.03, 0.0);
    veins.push_back(
        {VesselKind::HepaticVein, -1, apart, apart + turn * Vec3(0.006, 0, 0), 0.0015, true});
    const std::vector<VesselSegment> found =
        centreLines(tubes(veins, 0.4e-3), VesselKind::HepaticVein);
    int roots = 0, near = 0;
    for (const VesselSegment& s : found) {
      if (s.parent >= 0) continue;
      ++roots;
      near += (s.start - meeting).norm() < 0.01;
    }
    CHECK(roots == 4);
    CHECK(near == 3);
    // The same shape as a portal vein begins at wide ends.
    const std::vector<VesselSegment> portal =
        centreLines(tubes(veins, 0.4e-3), VesselKind::PortalVein);
    CHECK(std::ranges::count_if(portal, [&](const VesselSegment& s) {
            return s.parent < 0 && (s.start - meeting).norm() > 0.02;
          }) >= 2);
  }
}

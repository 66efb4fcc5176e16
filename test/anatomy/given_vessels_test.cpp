#include <doctest/doctest.h>

#include <algorithm>

#include "anatomy/ball_growth.h"
#include "anatomy/growth/vessel_growth.h"
#include "anatomy/measure_anatomy.h"
#include "anatomy/none_crosses.h"
#include "geometry/primitives.h"

using namespace resect;

namespace {

// What a scan would show of the veins of a grown organ: those of at least `thinnest`, m of radius.
std::vector<VesselSegment> wideVeins(const Anatomy& anatomy, double thinnest) {
  std::vector<VesselSegment> wide;
  std::vector<std::int32_t> number(anatomy.segments.size(), -1);
  for (std::size_t i = 0; i < anatomy.segments.size(); ++i) {
    VesselSegment s = anatomy.segments[i];
    const bool vein = s.kind == VesselKind::PortalVein || s.kind == VesselKind::HepaticVein;
    if (!vein || s.radius < thinnest || (s.parent >= 0 && number[std::size_t(s.parent)] < 0))
      continue;
    number[i] = std::int32_t(wide.size());
    if (s.parent >= 0) s.parent = number[std::size_t(s.parent)];
    wide.push_back(s);
  }
  return wide;
}

bool same(const VesselSegment& a, const VesselSegment& b) {
  return a.kind == b.kind && a.start == b.start && a.end == b.end && a.radius == b.radius;
}

}  // namespace

TEST_CASE("small vessels grow from the wide ones that a scan shows, wherever the organ lies") {
  const Pose place{Vec3(0.4, 0.1, -0.2),
                   Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()))};
  const TriangleMesh ball = sphereMesh(Vec3::Zero(), 0.06), organ = transformed(ball, place);
  const std::vector<VesselSegment> given =
      wideVeins(transformed(growVessels(ball, test::ballGrowth(4)), place), 2e-3);
  REQUIRE(given.size() > 20);
  REQUIRE(given.size() < 200);

  VesselGrowth g;
  g.terminals = 200;
  const Anatomy grown = growVessels(organ, g, given);
  const AnatomyMeasures m = measure(grown, organ);
  CHECK(m.kinds[0].terminals >= 200);
  CHECK(m.kinds[1].terminals >= 200);
  CHECK(m.kinds[2].terminals > 0.9 * m.kinds[0].terminals);
  CHECK(m.kinds[3].terminals > 0.9 * m.kinds[0].terminals);
  test::checkNoneCrosses(m);
  for (const VesselSegment& s : given)  // each is there, as it was
    CHECK(std::ranges::any_of(grown.segments, [&](const auto& t) { return same(s, t); }));
  for (const VesselSegment& s : grown.segments)
    if (s.parent >= 0) CHECK(s.radius <= grown.segments[std::size_t(s.parent)].radius * 1.05);
}

TEST_CASE("an artery that is given stays as it is, and nothing grows from it") {
  const TriangleMesh organ = sphereMesh(Vec3::Zero(), 0.06);
  const VesselSegment artery{VesselKind::HepaticArtery, -1,    Vec3(0.02, 0, 0),
                             Vec3(0.03, 0, 0.01),       0.001, true};
  const Anatomy grown = growVessels(organ, test::ballGrowth(4), {&artery, 1});
  const VesselRange range = grown.range(VesselKind::HepaticArtery);
  REQUIRE(range.count == 1);
  CHECK(same(grown.segments[std::size_t(range.first)], artery));
  CHECK(grown.range(VesselKind::BileDuct).count > 100);
}

// Couinaud's segments and the names of vessels.
#include "anatomy/liver_segments.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <bit>
#include <set>

#include "anatomy/growth/vessel_growth.h"
#include "anatomy/small_vessels.h"
#include "geometry/pose.h"
#include "geometry/primitives.h"
#include "geometry/rotation.h"

using namespace resect;

namespace {

// A tree by hand: liver of 20 cm with right at -x, ahead at +z, up at +y. Fork of the portal vein
// at the origin; hepatic veins meet 5 cm above. The ends of a branch lie a millimetre apart; a
// segment has as many of a hundred as it usually has of the liver's volume.
struct Plan {
  std::vector<VesselSegment> segments;

  std::int32_t add(VesselKind kind, std::int32_t parent, const Vec3& start, const Vec3& end,
                   double radius, bool leaf) {
    segments.push_back({kind, parent, start, end, radius, leaf});
    return std::int32_t(segments.size()) - 1;
  }
  void ends(VesselKind kind, std::int32_t parent, const Vec3& place, int count) {
    const Vec3 start = segments[std::size_t(parent)].end;
    const auto stem = add(kind, parent, start, place, 0.002, false);
    for (int i = 0; i < count; ++i)
      add(kind, stem, place, place + Vec3(1e-3 * (i - count / 2), 0, 5e-3), 0.001, true);
  }
};

const Vec3 kPlaces[kLiverSegments + 1] = {
    Vec3::Zero(),        {0.01, 0, -0.015},  {0.08, 0.03, 0.02},
    {0.08, -0.03, 0.03}, {0.02, 0, 0.08},    {-0.03, -0.03, 0.06},
    {-0.10, -0.03, 0.0}, {-0.10, 0.03, 0.0}, {-0.03, 0.03, 0.06}};

constexpr int kEnds[kLiverSegments + 1] = {0, 4, 8, 9, 15, 13, 9, 16, 26};

Anatomy planned() {
  Plan plan;
  const auto portal = VesselKind::PortalVein, hepatic = VesselKind::HepaticVein;
  const auto root = plan.add(portal, -1, {0, -0.05, 0}, Vec3::Zero(), 0.006, false);
  const auto right = plan.add(portal, root, Vec3::Zero(), {-0.02, 0, 0.01}, 0.004, false);
  const auto left = plan.add(portal, root, Vec3::Zero(), {0.02, 0, 0.01}, 0.004, false);
  const auto anterior = plan.add(portal, right, {-0.02, 0, 0.01}, {-0.025, 0, 0.03}, 0.003, false);
  const auto posterior = plan.add(portal, right, {-0.02, 0, 0.01}, {-0.05, 0, 0.0}, 0.003, false);
  for (const int s : {5, 8}) plan.ends(portal, anterior, kPlaces[s], kEnds[s]);
  for (const int s : {6, 7}) plan.ends(portal, posterior, kPlaces[s], kEnds[s]);
  for (const int s : {1, 2, 3, 4}) plan.ends(portal, left, kPlaces[s], kEnds[s]);
  for (const double x : {-0.06, 0.0, 0.05}) {
    const Vec3 far(x, 0, x == 0 ? 0.08 : 0.05);
    const auto trunk = plan.add(hepatic, -1, {0, 0.05, 0}, far, 0.004, false);
    plan.ends(hepatic, trunk, far + Vec3(0, -0.01, 0), 3);
  }
  return makeAnatomy(std::move(plan.segments));
}

}  // namespace

TEST_CASE("segments and names are found wherever the liver lies") {
  for (const Pose& pose :
       {Pose{}, Pose{Vec3(0.3, -1, 2), rotationAbout(Vec3(1, 2, -0.5).normalized(), 2.1)}}) {
    const Anatomy anatomy = transformed(planned(), pose);
    const auto segments = LiverSegments::find(anatomy);
    REQUIRE(segments);
    for (int s = 1; s <= kLiverSegments; ++s) {
      CAPTURE(s);
      CHECK(segments->at(pose * kPlaces[s]) == s);
    }
    const auto name = [&](int i) { return segments->nameOf(anatomy, i); };
    CHECK(name(0) == "portal vein");
    CHECK(name(1) == "right portal vein");
    CHECK(name(2) == "left portal vein");
    CHECK(name(3) == "right anterior portal vein");
    CHECK(name(4) == "right posterior portal vein");
    CHECK(name(5) == "portal branch of segment V");
    std::set<std::string> names;
    for (int i = 0; i < anatomy.range(VesselKind::PortalVein).count; ++i) names.insert(name(i));
    for (int s = 1; s <= kLiverSegments; ++s)
      CHECK(names.contains(fmt::format("portal branch of segment {}", romanNumber(s))));
    const VesselRange hepatic = anatomy.range(VesselKind::HepaticVein);
    CHECK(name(hepatic.first) == "right hepatic vein");
    CHECK(name(hepatic.first + 5) == "middle hepatic vein");
    CHECK(name(hepatic.first + 10) == "left hepatic vein");
  }
}

TEST_CASE("vessels that do not tell the segments are named by their kind") {
  const auto map = makeVesselMap(test::threeForks());
  CHECK(!map->segments);
  CHECK(map->nameOf(0) == "portal vein");
}

TEST_CASE("a branch that supplies segments of both halves of the liver is named by them") {
  Anatomy anatomy = planned();
  std::vector<VesselSegment> segments = anatomy.segments;
  // One more branch of the portal vein, with ends in the middle of IV and of V.
  const std::int32_t at = anatomy.range(VesselKind::PortalVein).count;
  std::vector<VesselSegment> more{
      {VesselKind::PortalVein, 0, Vec3::Zero(), {0, -0.01, 0.04}, 0.002, false},
      {VesselKind::PortalVein, at, {0, -0.01, 0.04}, kPlaces[4], 0.001, true},
      {VesselKind::PortalVein, at, {0, -0.01, 0.04}, kPlaces[5], 0.001, true}};
  for (std::size_t i = std::size_t(at); i < segments.size(); ++i)
    if (segments[i].parent >= 0) segments[i].parent += 3;
  segments.insert(segments.begin() + at, more.begin(), more.end());
  anatomy = makeAnatomy(std::move(segments));
  const auto found = LiverSegments::find(anatomy);
  REQUIRE(found);
  CHECK(found->nameOf(anatomy, at) == "portal branch of segments IV, V");
  CHECK(found->nameOf(anatomy, at + 1) == "portal branch of segment IV");
  CHECK(found->nameOf(anatomy, at + 2) == "portal branch of segment V");
}

TEST_CASE("a grown ball has all segments, and each end of a vessel supplies one of them") {
  const TriangleMesh ball = sphereMesh(Vec3::Zero(), 0.07);
  VesselGrowth growth;
  growth.hilum = Vec3(0.01, -0.05, 0.0), growth.hilumOut = Vec3(0.012, -0.09, 0);
  growth.cava = Vec3(0.01, 0.045, -0.035), growth.cavaOut = Vec3(0.012, 0.07, -0.055);
  growth.terminals = 200;
  const Anatomy anatomy = growVessels(ball, growth);
  const auto segments = LiverSegments::find(anatomy);
  REQUIRE(segments);
  std::set<int> found;
  for (std::size_t i = 0; i < anatomy.segments.size(); ++i) {
    const VesselSegment& s = anatomy.segments[i];
    const std::uint8_t own = segments->territory(std::int32_t(i));
    CHECK(own != 0);
    if (s.leaf) CHECK(std::has_single_bit(own));
    if (s.leaf) found.insert(segments->at(s.end));
  }
  CHECK(found.size() == kLiverSegments);
}

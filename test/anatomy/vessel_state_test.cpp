#include "anatomy/vessel_state.h"

#include <doctest/doctest.h>

#include <cmath>

#include "anatomy/small_vessels.h"
#include "support/sentence.h"

using namespace resect;

namespace {

const Anatomy kVessel =
    test::straightVessel(VesselKind::PortalVein, Vec3(0, 0, 0), Vec3(0.04, 0, 0), 0.002);

struct Cut {
  VesselState state;
  std::vector<std::int32_t> segments;
};

Cut cut(const SweptBlade& blade, VesselState state = {}) {
  Cut result{std::move(state), {}};
  cutVessels(kVessel, VesselIndex(kVessel.segments), blade, result.state, result.segments);
  return result;
}

}  // namespace

TEST_CASE("a blade across a vessel severs it where it crosses") {
  const Cut result = cut(test::acrossX(0.013, -0.01, 0.01));
  REQUIRE(result.state.injuries.size() == 1);
  const VesselInjury& injury = result.state.injuries[0];
  CHECK(injury.severed());
  CHECK(injury.share() == 1);
  CHECK(injury.from == doctest::Approx(0.013 / 0.04).epsilon(1e-12));
  CHECK(injury.to == injury.from);
  CHECK(result.segments == std::vector<std::int32_t>{0});
}

TEST_CASE("a blade that enters a vessel by half its width opens half of it") {
  const Cut result = cut(test::acrossX(0.02, 0, 0.01));
  REQUIRE(result.state.injuries.size() == 1);
  // Of 19 filaments of equal area: a filament lies on a radius, so one of them is 5 %.
  CHECK(std::abs(result.state.injuries[0].share() - 0.5) < 0.08);
  CHECK_FALSE(result.state.injuries[0].severed());
  // The other half, a millimetre farther on, makes two ends with a gap.
  const Cut both = cut(test::acrossX(0.021, -0.01, 1e-6), result.state);
  CHECK(both.state.injuries[0].severed());
  CHECK(both.state.injuries[0].from == doctest::Approx(0.5));
  CHECK(both.state.injuries[0].to == doctest::Approx(0.525));
}

TEST_CASE("a blade that passes beside a vessel or along it leaves it whole") {
  CHECK(cut(test::acrossX(0.02, 0.0021, 0.01)).state.injuries.empty());
  CHECK(cut(test::acrossX(0.05, -0.01, 0.01)).state.injuries.empty());
}

TEST_CASE("an oblique blade cuts each filament at its own place") {
  // The plane x = 0.02 + y.
  const Vec3 before[] = {{0.01, -0.01, -1}, {0.03, 0.01, -1}},
             after[] = {{0.01, -0.01, 1}, {0.03, 0.01, 1}};
  const Cut result = cut(ruledBlade(before, after));
  const double outermost = 0.87 * 0.002;
  CHECK(result.state.injuries[0].from >= (0.02 - outermost) / 0.04 - 1e-9);
  CHECK(result.state.injuries[0].from <= (0.02 - 0.9 * outermost) / 0.04);
  CHECK(result.state.injuries[0].to >= (0.02 + 0.9 * outermost) / 0.04);
}

TEST_CASE(
    "a box takes away the part of a vessel that lies in it, but spares wide vessels if told to") {
  VesselState state;
  std::vector<std::int32_t> segments;
  const Aabb box{Vec3(0.01, -0.01, -0.01), Vec3(0.016, 0.01, 0.01)};
  cutVessels(kVessel, VesselIndex(kVessel.segments), box, 0.001, state, segments);
  CHECK(state.injuries.empty());
  CHECK(state.bared == std::vector<std::int32_t>{0});
  cutVessels(kVessel, VesselIndex(kVessel.segments), box, 1, state, segments);
  REQUIRE(state.injuries.size() == 1);
  CHECK(state.injuries[0].severed());
  CHECK(state.injuries[0].from == doctest::Approx(0.25));
  CHECK(state.injuries[0].to == doctest::Approx(0.4));
}

TEST_CASE(
    "vessels are sealed where tissue is coagulated all round them, and a new cut opens them") {
  const VesselIndex index(kVessel.segments);
  const Aabb box{Vec3(0, -0.01, -0.01), Vec3(0.04, 0.01, 0.01)};
  const auto seal = [&](VesselState& state, const Vec3& place, double radius) {
    sealVessels(
        kVessel, index, box, [&](const Vec3& p) { return (p - place).norm() < radius ? 1.0 : 0.0; },
        state);
  };
  Cut result = cut(test::acrossX(0.02, -0.01, 0.01));
  seal(result.state, Vec3(0.03, 0, 0), 0.005);
  CHECK(result.state.injuries[0].sealed == 0);  // too far away
  seal(result.state, Vec3(0.02, 0.001, 0), 0.0025);
  CHECK(result.state.injuries[0].sealed == 0);  // on one side only
  seal(result.state, Vec3(0.02, 0.001, 0), 0.0035);
  CHECK(result.state.injuries[0].sealed == 3);
  const Cut again = cut(test::acrossX(0.01, -0.01, 0.01), result.state);
  CHECK_FALSE(again.state.injuries[0].isSealed(VesselEnd::Root));
  CHECK(again.state.injuries[0].isSealed(VesselEnd::Far));
}

TEST_CASE("a whole vessel that is sealed and then cut there is closed at both ends") {
  VesselState state;
  const Aabb box{Vec3(0.01, -0.01, -0.01), Vec3(0.03, 0.01, 0.01)};
  for (int i = 0; i < 3; ++i)
    sealVessels(
        kVessel, VesselIndex(kVessel.segments), box,
        [](const Vec3& p) { return std::abs(p.x() - 0.02) < 0.004 ? 1.0 : 0.0; }, state);
  REQUIRE(state.clips.size() >= 4);
  CHECK(state.clips.size() <= 7);  // each place once
  for (const VesselClip& clip : state.clips) CHECK(clip.byHeat);
  const Cut result = cut(test::acrossX(0.02, -0.01, 0.01), state);
  CHECK(result.state.clipped(result.state.injuries[0], VesselEnd::Root));
  CHECK(result.state.clipped(result.state.injuries[0], VesselEnd::Far));
}

TEST_CASE("a vessel can be divided at a place of it") {
  VesselState state;
  std::vector<std::int32_t> segments;
  divideVessel(0, 0.3, state, segments);
  REQUIRE(state.injuries.size() == 1);
  CHECK(segments == std::vector<std::int32_t>{0});
  CHECK(state.injuries[0].severed());
  CHECK(state.injuries[0].from == 0.3);
  CHECK(state.injuries[0].to == 0.3);
}

TEST_CASE("a clip closes the end on its side of the cut") {
  Cut result = cut(test::acrossX(0.02, -0.01, 0.01));
  result.state.addClip({0, 0.4});
  CHECK(result.state.clipped(result.state.injuries[0], VesselEnd::Root));
  CHECK_FALSE(result.state.clipped(result.state.injuries[0], VesselEnd::Far));
  result.state.addClip({0, 0.6});
  CHECK(result.state.clipped(result.state.injuries[0], VesselEnd::Far));
}

TEST_CASE("segments that are no tree are refused in a sentence") {
  const VesselSegment good{VesselKind::PortalVein, -1, Vec3::Zero(), Vec3::UnitX(), 0.001, true};
  const auto refused = [](std::vector<VesselSegment> segments, const char* what) {
    CHECK(test::refuses([&] { makeAnatomy(segments); }, what));
  };
  VesselSegment bad = good;
  bad.radius = 0;
  refused({bad}, "radius above 0");
  bad = good, bad.end.x() = std::nan("");
  refused({bad}, "finite");
  bad = good, bad.parent = 0;
  refused({bad}, "hangs on");
  bad = good, bad.kind = VesselKind::BileDuct, bad.parent = 0;
  refused({good, bad}, "of two kinds");
  bad.parent = -1;
  refused({good, bad, good}, "sort them by kind");
}

TEST_CASE("tissue that tears across a vessel cuts a thin one, and bares a wide one") {
  const SweptBlade face = test::acrossX(0.013, -0.01, 0.01);
  const VesselIndex index(kVessel.segments);
  for (const double spared : {0.0021, 0.0019}) {
    VesselState state;
    std::vector<std::int32_t> segments;
    tearVessels(kVessel, index, face, spared, state, segments);
    const bool cuts = spared > 0.002;
    CHECK(state.injuries.size() == std::size_t(cuts));
    CHECK(state.bared.size() == std::size_t(!cuts));
    CHECK(segments.size() == std::size_t(cuts));
  }
  VesselState state;
  std::vector<std::int32_t> segments;
  tearVessels(kVessel, index, test::acrossX(0.05, -0.01, 0.01), 0.001, state, segments);
  CHECK(state.bared.empty());  // beside it
}

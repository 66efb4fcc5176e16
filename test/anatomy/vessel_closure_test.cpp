#include "anatomy/vessel_closure.h"

#include <doctest/doctest.h>

#include "anatomy/small_vessels.h"

using namespace resect;

namespace {

constexpr std::uint32_t kAll = (1u << kFilaments) - 1;

// The portal vein's stem is segment 0, 30 mm long; its branches are 1 and 2, 28.3 mm long.
VesselState cutAt(std::int32_t segment, double share) {
  VesselState state;
  state.injuries.push_back({segment, kAll, share, share, 0, {0, 0}, 0});
  return state;
}

}  // namespace

TEST_CASE("the way from a cut end to a clip leads along the vessel, over forks, on its own side") {
  const Anatomy anatomy = test::threeForks();
  const VesselInjury injury = cutAt(1, 0.5).injuries[0];
  const double branch = anatomy.segments[1].length();
  const auto way = [&](VesselEnd end, VesselClip clip) {
    return wayToClip(anatomy, injury, end, clip, 0.03);
  };
  CHECK(*way(VesselEnd::Root, {1, 0.4}) == doctest::Approx(0.1 * branch));
  CHECK(*way(VesselEnd::Root, {0, 0.9}) == doctest::Approx(0.5 * branch + 0.003));
  CHECK(*way(VesselEnd::Far, {1, 0.75}) == doctest::Approx(0.25 * branch));
  CHECK_FALSE(way(VesselEnd::Far, {1, 0.4}));
  CHECK_FALSE(way(VesselEnd::Root, {1, 0.6}));
  CHECK_FALSE(way(VesselEnd::Root, {2, 0.1}));  // the other branch
  CHECK_FALSE(way(VesselEnd::Root, {0, 0.1}));  // too far
  CHECK_FALSE(way(VesselEnd::Far, {0, 0.9}));
  CHECK_FALSE(way(VesselEnd::Root, {4, 0.1}));  // of another tree
}

TEST_CASE("a divided vessel is closed by clips on both sides, but not where it still bleeds") {
  const Anatomy anatomy = test::threeForks();
  VesselState state = cutAt(1, 0.5);
  const auto closed = [&] { return isClosed(anatomy, state, state.injuries[0]); };
  CHECK_FALSE(closed());
  state.addClip({0, 0.9});
  CHECK_FALSE(closed());
  state.addClip({1, 0.8});
  CHECK(closed());
  state.injuries[0].flow[0] = 1e-6;  // through a branch between clip and cut
  CHECK_FALSE(closed());
  state.addClip({1, 0.3});
  CHECK(closed());
}

TEST_CASE("clips without a stump slip off, on either side and over a fork; others and welds hold") {
  const Anatomy anatomy = test::threeForks();
  const double branch = anatomy.segments[1].length();
  const auto kept = [&](double cut, VesselClip clip) {
    VesselState state = cutAt(1, cut);
    state.addClip(clip);
    const std::vector<VesselClip> slipped = slipClips(anatomy, {1}, state);
    CHECK(slipped.size() + state.clips.size() == 1);
    return state.clips.size() == 1;
  };
  CHECK_FALSE(kept(0.5, {1, 0.5 - 0.001 / branch}));
  CHECK_FALSE(kept(0.5, {1, 0.5 + 0.001 / branch}));
  CHECK_FALSE(kept(0.5, {1, 0.5}));
  CHECK(kept(0.5, {1, 0.5 - 0.003 / branch}));
  CHECK(kept(0.5, {1, 0.5 + 0.003 / branch}));
  CHECK(kept(0.5, {1, 0.5 - 0.001 / branch, true}));
  CHECK_FALSE(kept(0.0005 / branch, {0, 1 - 0.0005 / 0.03}));
  CHECK(kept(0.0005 / branch, {0, 1 - 0.002 / 0.03}));
  VesselState hole = cutAt(1, 0.5);  // not severed
  hole.injuries[0].cut = 0b111;
  hole.addClip({1, 0.5});
  CHECK(slipClips(anatomy, {1}, hole).empty());
}

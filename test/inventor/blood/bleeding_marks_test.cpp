// The rings that mark what bleeds.
#include "inventor/hand/marks/bleeding_marks.h"

#include <doctest/doctest.h>

using namespace resect;

namespace {

BleedingEnd bleeding(double millilitresPerMinute, const Vec3& place) {
  BleedingEnd end;
  end.place = place;
  end.flow = millilitresPerMinute * 1e-6 / 60;
  return end;
}

double radiusOf(const MarkLine& ring, const Vec3& middle) {
  return (ring.points.front() - middle).norm();
}

}  // namespace

TEST_CASE("the ring of what bleeds much is told at a glance from that of what bleeds little") {
  const std::vector<BleedingEnd> ends{bleeding(3, {0, 0, 0}), bleeding(27, {0.1, 0, 0}),
                                      bleeding(460, {0.2, 0, 0})};
  const std::vector<MarkLine> rings = bleedingRings(ends, {}, Vec3::UnitZ());
  REQUIRE(rings.size() == 3);
  for (std::size_t i = 1; i < ends.size(); ++i)
    CHECK(radiusOf(rings[i], ends[i].place) > 1.3 * radiusOf(rings[i - 1], ends[i - 1].place));
  // The white double ring of a small end stays smaller than the ring of one that spurts.
  const std::vector<MarkLine> chosen = bleedingRings(ends, ends[1].place, Vec3::UnitZ());
  REQUIRE(chosen.size() == 4);
  CHECK(chosen[1].colour == Vec3f(1, 1, 1));
  CHECK(radiusOf(chosen[2], ends[1].place) < radiusOf(chosen[3], ends[2].place));
}

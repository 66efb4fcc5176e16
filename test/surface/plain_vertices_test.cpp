// Vertices made four at a time equal those found edge by edge.
#include "support/references/plain_vertices.h"

#include <doctest/doctest.h>

#include <map>

#include "base/random.h"
#include "support/block_organ.h"
#include "support/surface_look.h"

using namespace resect;

namespace {

struct EarlierPlace {
  bool operator()(const Vec3f& a, const Vec3f& b) const {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  }
};

void checkAgainstPlain(const ColourField& field, float iso) {
  const SurfaceTracker::Compact surface = test::withLook(field, iso);
  std::map<Vec3f, std::size_t, EarlierPlace> found;
  for (std::size_t i = 0; i < surface.mesh.points.size(); ++i)
    found[surface.mesh.points[i].cast<float>()] = i;
  const std::vector<test::PlainVertex> expected = test::plainVertices(field, iso);
  REQUIRE(found.size() == expected.size());
  std::size_t elsewhere = 0, askew = 0, otherwiseCut = 0;
  for (const test::PlainVertex& v : expected) {
    const auto at = found.find(v.point);  // to the last bit
    if (at == found.end()) {
      ++elsewhere;
      continue;
    }
    askew += !((surface.normals[at->second].cast<double>() - v.normal).norm() < 2e-4);
    otherwiseCut += !(std::abs(surface.cut[at->second] - v.cut) < 1e-4);
  }
  CHECK(elsewhere == 0);
  CHECK(askew == 0);
  CHECK(otherwiseCut == 0);
}

}  // namespace

TEST_CASE("vertices, normals and shares of cut are those found edge by edge") {
  for (const int refine : {1, 2, 3, 4}) {
    CAPTURE(refine);
    checkAgainstPlain(ColourField(test::ball(9), refine), 50);
    Discretization stretched = test::noise({7, 6, 5}, 11);
    stretched.lattice.spacing = Vec3(0.004, 0.005, 0.0065);
    for (const float iso : {30.f, 50.f, 70.f})
      checkAgainstPlain(ColourField(stretched, refine), iso);

    ColourField carved(test::fullBlock({8, 8, 8}), refine);
    Random random(4);
    for (int i = 0; i < 40; ++i)
      carved.setCellValue(std::int64_t(random.below(512)), i % 3 == 0 ? 60.f : 0.f);
    carved.update();
    checkAgainstPlain(carved, 50);
  }
}

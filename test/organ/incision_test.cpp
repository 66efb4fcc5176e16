#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "anatomy/visible_human.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/discretize.h"
#include "organ/incision/strands.h"
#include "organ/organ.h"
#include "organ/parts/bodies.h"
#include "support/blades.h"
#include "support/block_organ.h"
#include "support/references/wound_reference.h"
#include "tissue/elastic/elastic_tissue.h"
#include "tissue/stencil.h"
#include "tissue/still_tissue.h"

using namespace resect;

namespace {

void follow(Organ& organ) { updateSurface(organ, updateField(organ)); }

Vec3 middle(const Organ& organ) { return organ.rest.lattice.box().centre(); }

}  // namespace

TEST_CASE("an incision takes nothing away") {
  Organ organ = makeOrgan(test::blob(20), {});
  const double before = volume(organ.surface.mesh()), tissue = organ.volume();
  const std::int64_t particles = organ.particles;
  CHECK(incise(organ, test::flatBlade(middle(organ) + Vec3(0, 0.04, 0), Vec3(0.02, 0, 0.003),
                                      Vec3(0, 0.03, 0))) > 100);
  follow(organ);
  const TriangleMesh mesh = organ.surface.mesh();
  CHECK(test::wrongWith(mesh) == "");
  CHECK(std::abs(volume(mesh) / before - 1) < 1e-8);
  CHECK(organ.volume() == tissue);
  CHECK(organ.particles == particles);
  CHECK(bodies(organ).size() == 1);
}

TEST_CASE("cut right through, an organ is separate closed bodies whose volumes add up") {
  Organ organ = makeOrgan(test::blob(24), {});
  const double whole = volume(organ.surface.mesh());
  incise(organ, test::flatBlade(middle(organ) + Vec3(0.0011, 0.0013, 0.0007),
                                Vec3(0.2, 0.013, 0.007), Vec3(-0.011, 0.04, 0.2)));
  incise(organ, test::flatBlade(middle(organ) + Vec3(0.0317, 0.0013, 0.0007),
                                Vec3(0.013, 0.2, 0.007), Vec3(-0.011, 0.04, 0.2)));
  follow(organ);
  const auto pieces = bodies(organ);
  double sum = 0, tissueSum = 0;
  std::int64_t particleSum = 0;
  int large = 0;
  for (const auto& [piece, particles, tissue, labels] : pieces) {
    CHECK(test::wrongWith(piece) == "");
    CHECK(volume(piece) > 0);
    CHECK(particles > 0);
    particleSum += particles;
    tissueSum += tissue;
    large += volume(piece) > 0.01 * whole;
    sum += volume(piece);
  }
  MESSAGE(pieces.size(), " bodies, ", large, " of them more than a hundredth; volumes add up to ",
          sum / whole, " of the whole");
  CHECK(large == 4);
  CHECK(particleSum == organ.particles);
  CHECK(tissueSum == doctest::Approx(organ.volume()).epsilon(1e-9));
  CHECK(std::abs(sum / whole - 1) < 1e-8);  // points are floats
  for (std::size_t i = 1; i < pieces.size(); ++i)
    CHECK(volume(pieces[i - 1].mesh) >= volume(pieces[i].mesh));
}

TEST_CASE("a cut with a kerf leaves a gap of that width, closed at its front") {
  constexpr float kKerf = 0.5e-3f;  // m
  for (const int refine : {1, 2, 3})
    for (const Vec3& up : {Vec3(0, 0.2, 0), Vec3(0.09, 0.2, 0), Vec3(0.1, 0.2, 0.12)})
      for (const bool through : {true, false}) {
        CAPTURE(refine);
        CAPTURE(up.transpose());
        CAPTURE(through);
        Organ organ = makeOrgan(test::blob(20), {refine, 50});
        const double whole = area(organ.surface.mesh());
        Vec3 start = middle(organ) + Vec3(0.0011, 0, 0.0007);
        if (!through) start += up;
        incise(organ, test::flatBlade(start, Vec3(-0.3 * up.y(), 0.3 * up.x(), 0.2), up));
        follow(organ);
        const TriangleMesh shut = organ.surface.mesh();
        organ.kerf = kKerf;
        setIso(organ, organ.iso);
        const TriangleMesh open = organ.surface.mesh();
        CHECK(test::wrongWith(open) == "");
        CHECK(open.triangles == shut.triangles);
        const double cut = 0.5 * (area(shut) - whole);  // m^2
        CHECK(cut > 2e-4);
        CHECK((volume(shut) - volume(open)) / (cut * double(kKerf)) ==
              doctest::Approx(1).epsilon(0.05));
        double most = 0;
        for (std::size_t v = 0; v < open.points.size(); ++v)
          most = std::max(most, (open.points[v] - shut.points[v]).norm());
        CHECK(most == doctest::Approx(0.5 * double(kKerf)).epsilon(0.01));
      }
}

TEST_CASE("bodies of moved tissue are closed at their present places") {
  Organ organ = makeOrgan(test::blob(18), {});
  incise(organ, test::flatBlade(middle(organ) + Vec3(0.0003, 0.0004, 0.0005), Vec3(0.2, 0.01, 0.02),
                                Vec3(0.01, 0.01, 0.2)));
  follow(organ);
  std::vector<Vec3f> moved;
  for (const Vec3f& p : organ.surface.points()) moved.push_back(1.1f * p + Vec3f(0.1f, 0, 0));
  const auto still = bodies(organ), there = bodies(organ, organ.surface.mesh(moved));
  REQUIRE(there.size() == still.size());
  REQUIRE(there.size() >= 2);
  for (std::size_t i = 0; i < there.size(); ++i) {
    CHECK(test::wrongWith(there[i].mesh) == "");
    CHECK(std::abs(volume(there[i].mesh) / volume(still[i].mesh) - 1.331) < 1e-3);
  }
}

TEST_CASE("a blind cut within is no body of its own") {
  Organ organ = makeOrgan(test::blob(20), {});
  incise(organ, test::flatBlade(middle(organ), Vec3(0.015, 0, 0.001), Vec3(0, 0.001, 0.015)));
  follow(organ);
  CHECK(topology(organ.surface.mesh()).components == 2);
  CHECK(bodies(organ).size() == 1);
}

TEST_CASE(
    "where all bonds between two halves are gone the surface parts too, whatever blades did") {
  for (const int blades : {0, 1, 2})  // that went beside the plane of the bonds, and not through
    for (const bool skinned : {false, true}) {
      const Discretization cells = skinned ? test::ball(13) : test::fullBlock({8, 7, 6});
      Organ organ = makeOrgan(cells, {});
      ElasticTissue tissue({cells.lattice, cells.inside, {TissueMaterial{}}, {}}, {});
      const double whole = volume(organ.surface.mesh());
      const Lattice& lattice = organ.rest.lattice;
      std::vector<TissueBond> bonds;
      std::vector<std::int64_t> near;
      for (std::int64_t c = 0; c < lattice.cellCount(); ++c) {
        if (lattice.cell(c).x() != 3 || !cells.inside[c]) continue;
        near.push_back(c);
        for (int d = 0; d < kDirections; ++d)
          if (offsetAlong(d, 0) == 1 && tissue.bonds(c) >> d & 1) {
            bonds.push_back({c, d});
            tissue.sever(c, d);
          }
      }
      for (int blade = 0; blade <= blades; ++blade) {
        if (blade > 0)
          incise(organ, test::flatBlade(lattice.centre({3, 3, 1 + 2 * blade}) +
                                            Vec3((blade == 1 ? 0.6 : 0.4) * 0.005, 0, 0),
                                        Vec3(0.0002, 0, 0.01), Vec3(0, 0.02, 0.0003)));
        partStrands(organ, tissue, bonds, near);
        bonds.clear();
      }
      follow(organ);
      CHECK(test::wrongWith(organ.surface.mesh()) == "");
      const auto pieces = bodies(organ);
      REQUIRE(pieces.size() == 2);
      if (!skinned) CHECK(pieces[0].particles == 168);
      CHECK(pieces[0].particles + pieces[1].particles == organ.particles);
      CHECK(std::abs((volume(pieces[0].mesh) + volume(pieces[1].mesh)) / whole - 1) < 1e-8);
    }
}

TEST_CASE("a cut organ can be carved, and carved away, and its iso level changed") {
  Organ organ = makeOrgan(test::blob(18), {});
  incise(organ, test::flatBlade(middle(organ), Vec3(0.2, 0.01, 0.02), Vec3(0.01, 0.01, 0.2)));
  follow(organ);
  setIso(organ, 30);
  CHECK(test::wrongWith(organ.surface.mesh()) == "");
  setIso(organ, 50);
  for (std::int64_t i = 0; i < organ.rest.lattice.cellCount(); ++i)
    if (organ.alive[std::size_t(i)] && organ.rest.lattice.cell(i).x() < 9) removeParticle(organ, i);
  follow(organ);
  CHECK(test::wrongWith(organ.surface.mesh()) == "");
  CHECK(bodies(organ).size() >= 2);
  for (std::int64_t i = 0; i < organ.rest.lattice.cellCount(); ++i)
    if (organ.alive[std::size_t(i)]) removeParticle(organ, i);
  follow(organ);
  CHECK(organ.surface.mesh().triangles.empty());
  CHECK(bodies(organ).empty());
}

TEST_CASE("a liver cut twenty times at random stays closed, keeps its volume and adds up") {
  std::vector<TriangleMesh> livers = {builtinLiver(0.005)};
  if (const auto real = test::visibleHumanLiver()) livers.push_back(*real);
  for (const TriangleMesh& liver : livers) {
    Organ organ = makeOrgan(discretize(liver, latticeForSpacing(bounds(liver), 0.006)), {});
    const double whole = volume(organ.surface.mesh());
    Random random(12);
    double worst = 0;
    for (int cut = 0; cut < 20; ++cut) {
      INFO("cut ", cut);
      incise(organ, test::randomBlade(middle(organ), 0.08, 0.006, random));
      follow(organ);
      const TriangleMesh mesh = organ.surface.mesh();
      REQUIRE(test::wrongWith(mesh) == "");
      worst = std::max(worst, std::abs(volume(mesh) / whole - 1));
    }
    const auto pieces = bodies(organ);
    double sum = 0;
    int crumbs = 0;
    for (const auto& [piece, particles, tissue, labels] : pieces) {
      REQUIRE(test::wrongWith(piece) == "");
      sum += volume(piece);
      crumbs += volume(piece) < 8 * organ.rest.lattice.cellVolume();
    }
    MESSAGE(organ.severed.count(), " edges severed; volume off by at most ", worst, "; ",
            pieces.size(), " bodies, ", crumbs, " smaller than 8 cells; together ", sum / whole);
    CHECK(worst < 1e-8);  // points are floats
    CHECK(std::abs(sum / whole - 1) < 1e-8);
  }
}

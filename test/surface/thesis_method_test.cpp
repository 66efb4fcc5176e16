#include "support/references/thesis_method.h"

#include <doctest/doctest.h>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "support/block_organ.h"
#include "support/surface_look.h"
#include "surface/surface_tracker.h"

using namespace resect;

namespace {

// All cells of a lattice as the thesis's particles.
std::vector<test::ThesisParticle> particlesOf(const Discretization& d) {
  std::vector<test::ThesisParticle> particles;
  for (std::int64_t i = 0; i < d.lattice.cellCount(); ++i)
    particles.push_back(
        {d.lattice.centre(d.lattice.cell(i)), d.lattice.cellVolume(), double(d.value[i])});
  return particles;
}

// The nodes of a colour field as a grid of the thesis.
test::ThesisGrid gridOf(const ColourField& field) {
  const Vec3i last = field.nodeDims() - Vec3i::Ones();
  return {{field.nodePosition(Vec3::Zero()), field.nodePosition(last.cast<double>())},
          field.nodeDims()};
}

}  // namespace

TEST_CASE("on the same nodes the thesis's method draws the same surface") {
  for (const Discretization& d : {test::ball(9), test::noise({6, 5, 7}, 3)}) {
    const ColourField field(d, 2);
    const auto ours = test::withLook(field, 50);
    test::ThesisMethod thesis(gridOf(field), kSmoothingPerSpacing * d.lattice.spacing.x(), 50);
    const auto particles = particlesOf(d);
    const test::ThesisSurface surface = thesis.update(particles);

    const Vec3i n = field.nodeDims();
    for (std::int64_t i = 0; i < std::int64_t(thesis.grid().count()); ++i) {
      const Vec3i node(int(i % n.x()), int(i / n.x() % n.y()), int(i / n.x() / n.y()));
      REQUIRE(std::abs(field.node(node) - thesis.field()[i]) < 2.2e-4);
    }
    CHECK(surface.mesh.points.size() == ours.mesh.points.size());
    CHECK(surface.mesh.triangles.size() == ours.mesh.triangles.size());
    CHECK(volume(surface.mesh) == doctest::Approx(volume(ours.mesh)).epsilon(1e-4));
    CHECK(area(surface.mesh) == doctest::Approx(area(ours.mesh)).epsilon(1e-3));
    CHECK(topology(surface.mesh).closed());
    CHECK(topology(surface.mesh).oriented());
  }
}

TEST_CASE("passing over particles out of reach changes nothing") {
  const Discretization d = test::ball(8);
  const auto particles = particlesOf(d);
  const test::ThesisMethod thesis({d.lattice.box(), {4, 4, 4}}, 0.004, 50);
  for (const test::ThesisParticle& p : particles) {
    const Vec3 r = p.position + Vec3(0.001, 0.002, -0.0005);
    CHECK(thesis.getLevelSet(particles, r) == thesis.getLevelSetNear(particles, r));
  }
}

// The organ's capsule: its law, its stability, what it does to a layer that is pressed, how it
// tears.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "base/state/saved_state.h"
#include "geometry/measures.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/discretize.h"
#include "organ/skin/touch_surface.h"
#include "organ/tissue_cells.h"
#include "support/figures.h"
#include "support/frequency.h"
#include "support/moved_tissue.h"

using namespace resect;
using test::kFrame;

namespace {

TissueMaterial underCapsule(double young) {
  TissueMaterial m = test::material(young, 0.45);
  m.capsule = 624;
  return m;
}

// Skin on the upper faces of a block, sixteen patches a face, with that normal.
std::vector<SurfacePatch> skinOn(const TissueCells& cells, const Vec3& normal) {
  constexpr int kSide = 4;
  const Lattice& lattice = cells.lattice;
  const double s = lattice.spacing.x();
  std::vector<SurfacePatch> patches;
  for (std::int64_t c = 0; c < lattice.cellCount(); ++c) {
    if (lattice.cell(c).y() != lattice.dims.y() - 1) continue;
    for (int k = 0; k < kSide * kSide; ++k) {
      const Vec3 at((k % kSide + 0.5) / kSide - 0.5, 0.5, (k / kSide + 0.5) / kSide - 0.5);
      const Vec3 place = lattice.centre(lattice.cell(c)) + s * at;
      patches.push_back({c, place.cast<float>(), (s * s / (kSide * kSide) * normal).cast<float>()});
    }
  }
  return patches;
}

void deform(ElasticTissue& tissue, const Mat3& f) {
  test::forEachSolid(tissue, [&](std::int64_t c, const Vec3i& at) {
    tissue.setDisplacement(c, (f - Mat3::Identity()) * tissue.lattice().centre(at));
  });
}

}  // namespace

TEST_CASE("the capsule's energy is that of a membrane that wrinkles, however it lies") {
  // Energy over E t and area: of the two stretches minus 1.
  struct Case {
    double d1, d2, energy;
  };
  for (const auto& [d1, d2, energy] :
       {Case{0.1, 0, 0.5 * 4 / 3 * 0.01}, Case{0.1, 0.1, 4.0 / 3 * 0.015},
        Case{0.1, -0.05, 0.5 * 0.01}, Case{0.1, -0.3, 0.5 * 0.01}, Case{-0.1, -0.2, 0},
        Case{0.4, -0.02, 0.5 * 4 / 3 * (0.16 - 0.4 * 0.02 + 0.0004)}})
    for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(1, 1, 1), Vec3(-1, 2, 0.5), Vec3(0, 0, -1)})
      for (const double turn : {0.0, 0.4}) {
        const TissueCells cells = test::solidBlock({6, 4, 5}, 0.008, underCapsule(1));
        ElasticTissue bare(cells, test::weightless()), skinned(cells, test::weightless());
        const auto skin = skinOn(cells, normal.normalized());
        skinned.setSurface(skin);
        const Vec3 n = normal.normalized(), t = Eigen::AngleAxisd(turn, n) * n.unitOrthogonal();
        const Vec3 other = n.cross(t);
        const Mat3 f = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix() *
                       (Mat3::Identity() + d1 * t * t.transpose() + d2 * other * other.transpose());
        deform(bare, f);
        deform(skinned, f);
        const double expected = 624 * 0.008 * 0.008 * double(skin.size() / 16) * energy;
        CHECK(skinned.energy().elastic - bare.energy().elastic ==
              doctest::Approx(expected).epsilon(1e-3).scale(1e-4));
      }
}

namespace {

// Severs all bonds across the plane in front of cell x of a block.
void cutAcross(ElasticTissue& tissue, int x) {
  test::forEachSolid(tissue, [&](std::int64_t c, const Vec3i& at) {
    for (int d = 0; d < kDirections; ++d)
      if (at.x() == x && offsetOf(d).x() < 0 && tissue.bonds(c) >> d & 1) tissue.sever(c, d);
  });
  tissue.settle();
}

void checkSlopes(bool wounded) {
  TissueMaterial material = underCapsule(2000);
  material.capsuleTension = 30;
  TissueCells cells = test::solidBlock({7, 5, 6}, 0.008, material);
  ElasticTissue tissue(cells, test::weightless());
  tissue.setSurface(skinOn(cells, Vec3(0.2, 1, -0.3).normalized()));
  if (wounded) cutAcross(tissue, 3);
  Random random(5);
  std::vector<std::int64_t> all;
  test::forEachSolid(tissue, [&](std::int64_t c, const Vec3i& at) {
    const Vec3 shaken(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const Vec3 x = tissue.lattice().centre(at);
    tissue.setDisplacement(c, 0.1 * Vec3(x.x(), x.z(), -0.5 * x.z()) + 0.0004 * shaken);
    all.push_back(c);
  });
  tissue.evaluateForces();
  double largest = 0, worst = 0;
  for (std::size_t k = 0; k < all.size(); k += 3) {
    const Vec3 here = tissue.displacement(all[k]), force = tissue.elasticForce(all[k]);
    largest = std::max(largest, force.norm());
    for (int a = 0; a < 3; ++a) {
      constexpr double kStep = 2e-5;
      const auto energyAt = [&](double step) {
        tissue.setDisplacement(all[k], here + step * Vec3::Unit(a));
        return tissue.energy().elastic;
      };
      const double slope = (energyAt(kStep) - energyAt(-kStep)) / (2 * kStep);
      tissue.setDisplacement(all[k], here);
      worst = std::max(worst, std::abs(force[a] + slope));
    }
  }
  MESSAGE("largest error " << worst / largest);
  CHECK(worst < 0.01 * largest);
}

}  // namespace

TEST_CASE("the capsule's forces are the slope of its energy, round a wound too") {
  checkSlopes(false);
  checkSlopes(true);
}

// A bar under a capsule in tension T, cut across. Cells move along the bar only. The capsule pulls
// each half back by the integral of T w / (E h + 4/3 E t), where w falls from 1 at the cut to 0 at
// 60 mm, and h is the height of the bar.
TEST_CASE("a cut through a capsule in tension gapes as far as theory says") {
  test::Figures figures("capsule retraction");
  constexpr double kTension = 5, kYoung = 20000, kReach = 0.06;
  for (const double spacing : {0.008, 0.005, 0.0025}) {
    TissueMaterial material = test::material(kYoung, 0);
    material.capsule = 100;
    material.capsuleTension = kTension;
    const int half = int(0.1 / spacing);
    const TissueCells cells = test::solidBlock({2 * half, 3, 3}, spacing, material);
    TissueSettings settings = test::weightless();
    settings.drag = 20;
    ElasticTissue tissue(cells, settings);
    tissue.setSurface(skinOn(cells, Vec3::UnitY()));
    test::forEachSolid(tissue, [&](std::int64_t c, const Vec3i& at) {
      const bool end = at.x() == 0 || at.x() == 2 * half - 1;
      tissue.hold(c, end ? int(kHeldAll) : kHeldY | kHeldZ);
    });
    tissue.settle();
    const auto gape = [&] {  // mean over the height
      const Lattice& lattice = tissue.lattice();
      double sum = 0;
      for (int y = 0; y < 3; ++y)
        sum += (tissue.displacement(lattice.index({half, y, 1})) -
                tissue.displacement(lattice.index({half - 1, y, 1})))
                   .x();
      return sum / 3;
    };
    for (int i = 0; i < 10; ++i) tissue.advance(kFrame);
    CHECK(std::abs(gape()) < 1e-9);  // the intact capsule pulls nothing
    cutAcross(tissue, half);
    for (int i = 0; i < 300; ++i) tissue.advance(kFrame);
    const double expected = kTension * kReach / (kYoung * 3 * spacing + 4.0 / 3 * material.capsule);
    CHECK(figures.add(fmt::format("gape, cells of {:g} mm", 1e3 * spacing), gape(), expected, 0.1) <
          0.1);
  }
}

// A lip is an end of the capsule that was made by an edit; what is removed makes lips too.
TEST_CASE("the capsule draws back round every wound, and as before after a restore") {
  TissueMaterial material = underCapsule(2000);
  material.capsuleTension = 30;
  const TissueCells cells = test::solidBlock({20, 4, 6}, 0.008, material);
  ElasticTissue tissue(cells, test::weightless());
  tissue.setSurface(skinOn(cells, Vec3::UnitY()));
  const auto restore = [&](const SavedState& saved) {
    tissue.beginRestore();
    loadState(tissue, saved);
    tissue.endRestore({});
  };
  const auto& state = tissue.state();
  CHECK(state.lips.empty());
  const SavedState intact = saveState(tissue, 1);
  cutAcross(tissue, 15);
  CHECK(state.lips.size() == 12);
  const auto removed = cells.lattice.index({4, 3, 2});
  tissue.remove(removed);
  tissue.settle();
  CHECK(state.lips.size() == 12 + 8);
  const auto tightness = state.tightness;
  const auto lips = state.lips;
  const SavedState wounded = saveState(tissue, 1);
  restore(intact);
  CHECK(state.lips.empty());
  CHECK(*std::ranges::max_element(state.tightness) == 0);
  restore(wounded);
  CHECK(state.lips == lips);
  CHECK(state.tightness == tightness);
}

TEST_CASE("the substep is stable with a capsule, on any cells") {
  test::Figures figures("capsule stability");
  const TriangleMesh mesh = builtinLiver(0.005);
  TissueSettings settings = test::weightless();
  const double limit = 2 / std::sqrt(1 + 2 * settings.damping);
  const Mat3 states[] = {1.0005 * Mat3::Identity(), Vec3(1.3, 0.9, 0.9).asDiagonal(),
                         Vec3(1.3, 1.3, 0.6).asDiagonal(), 1.2 * Mat3::Identity()};
  for (const double spacing : {0.0115, 0.008, 0.0055}) {
    const Discretization part = discretize(mesh, latticeForSpacing(bounds(mesh), spacing));
    const TissueCells cells = tissueCells(part, liverTissue());
    const std::vector<SurfacePatch> skin = touchSurface(makeOrgan(part, {}));
    double share = 0;
    for (const Mat3& f : states) {
      ElasticTissue tissue(cells, settings);
      tissue.setSurface(skin);
      deform(tissue, f);
      std::vector<std::int64_t> all;
      std::vector<Vec3> u;
      test::forEachSolid(tissue, [&](std::int64_t c, const Vec3i&) {
        all.push_back(c);
        u.push_back(tissue.displacement(c));
        tissue.hold(c, kHeldAll);
      });
      share =
          std::max(share, test::highestFrequency(tissue, all, u) * tissue.presentSubstep() / limit);
    }
    const std::string name =
        fmt::format("substep / longest stable, cells of {:g} mm", 1e3 * spacing);
    CHECK(figures.addError(name, share, 1) < 1);
    CHECK(share > 0.5);  // no longer substep is given away than needed
  }
}

namespace {

// Force on a ball with a radius of 8 mm that was pressed into a layer, N.
double pressedByBall(double spacing, double depth, const Vec3& place, bool capsule) {
  test::TissueLayer layer(spacing, 0.032, 30, liverTissue());
  if (capsule) layer.tissue.setSurface(skinOn(layer.cells, Vec3::UnitY()));
  const SignedDistance ball = test::ballOf(0.008);
  const Vec3 top = layer.top + spacing * place;
  TissueStep step;
  for (int i = 0; i < 90; ++i) {
    const auto pose = [&](int frame) {
      return Pose{top - Vec3(0, depth * std::min(1.0, frame / 20.0), 0),
                  Eigen::Quaterniond::Identity()};
    };
    const Obstacle tool = test::instrument(0, &ball, pose(i), pose(i + 1), 0, 0);
    test::moveAndTear(layer.tissue, kFrame, {&tool, 1}, step);
  }
  return step.force[0].y();
}

}  // namespace

TEST_CASE("a layer with a capsule is 5 to 9 % stiffer to press") {
  test::Figures figures("capsule pressed");
  const std::pair<const char*, Vec3> places[] = {{"a centre", {0, 0, 0}},
                                                 {"a corner", {0.5, 0, 0.5}}};
  for (const double spacing : {0.005, 0.004})
    for (const auto& [name, place] : places) {
      const double with = pressedByBall(spacing, 0.004, place, true);
      const double without = pressedByBall(spacing, 0.004, place, false);
      const double stiffer = with / without - 1;
      CHECK(figures.add(fmt::format("stiffer by, cells of {:g} mm, over {}", 1e3 * spacing, name),
                        stiffer, 0.069, 0.3) < 0.3);
      CHECK(stiffer > 0.05);
      CHECK(stiffer < 0.09);
    }
}

namespace {

// A strip of skin on very soft tissue, 20 x 12 cells of 8 mm, pulled at its ends. notch: cells that
// are cut into it in its middle, from one side.
struct Strip {
  TissueCells cells = test::solidBlock({20, 2, 12}, 0.008, underCapsule(300));
  ElasticTissue tissue{cells, settings()};

  explicit Strip(int notch) {
    tissue.setSurface(skinOn(cells, Vec3::UnitY()));
    test::forEachSolid(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.x() < 2 || at.x() > 17) tissue.hold(c, kHeldAll, speed(at));
      for (int d = 0; d < kDirections; ++d)
        if (at.z() < notch && at.x() == 9 && offsetOf(d).x() > 0 && tissue.bonds(c) >> d & 1)
          tissue.sever(c, d);
    });
    tissue.settle();
  }
  static TissueSettings settings() {
    TissueSettings settings = test::weightless();
    settings.drag = 20;
    return settings;
  }
  static Vec3 speed(const Vec3i& at) { return Vec3(at.x() < 10 ? -0.01 : 0.01, 0, 0); }
  int torn() const {
    const auto& flags = tissue.state().capsuleTorn;
    return int(std::count(flags.begin(), flags.end(), 1));
  }
  // Mean tension of the skin at the section x, N/m.
  double tension(int x) {
    double sum = 0;
    for (std::int64_t c = 0; c < tissue.lattice().cellCount(); ++c)
      if (tissue.lattice().cell(c).x() == x && tissue.lattice().cell(c).y() == 1)
        sum += tissue.stress(c)(0, 0) * 0.008;
    return sum / 12;
  }
  // Pulls until the skin tears. Returns the largest mean tension before.
  double pull(int section) {
    double most = 0;
    for (int i = 0; i < 400 && torn() == 0; ++i) {
      most = std::max(most, tension(section));
      tissue.advance(kFrame);
    }
    return most;
  }
};

}  // namespace

TEST_CASE("the capsule tears at its strength, and earlier from an edge that was cut") {
  Strip whole(0);
  const double strength = whole.pull(9);
  MESSAGE("whole: " << strength << " N/m");
  // The ends keep their width, so the tension in their corners is above the mean.
  CHECK(strength > 210);
  CHECK(strength < 300);

  Strip notched(4);
  const double less = notched.pull(14);
  MESSAGE("cut into by a third: " << less << " N/m");
  CHECK(less < 0.6 * strength);
  // It begins at the end of the cut and runs across.
  const Vec3 end = notched.tissue.lattice().centre({9, 1, 4});
  std::int64_t first = -1;
  test::forEachSolid(notched.tissue, [&](std::int64_t c, const Vec3i&) {
    if (notched.tissue.state().capsuleTorn[notched.tissue.state().box.fromLattice(c)]) first = c;
  });
  REQUIRE(first >= 0);
  CHECK((notched.tissue.lattice().centre(notched.tissue.lattice().cell(first)) - end).norm() <
        2 * 0.008);
  for (int i = 0; i < 60; ++i) notched.tissue.advance(kFrame);
  CHECK(notched.torn() > 6);
  CHECK(notched.torn() < 60);
}

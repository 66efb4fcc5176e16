// Beams that lie oblique in the lattice bend as theory says, by virtue of boundary cells.
//
// A free beam is bent by loads q(s) = q0 cos(2 pi s / L) across it, s from its middle. They are in
// balance, and neither moment nor shear force is left at the ends, so no wall has to be modelled.
// The loads on single particles add up to this only roughly; so theory is asked about the forces
// that act in fact. The work of the loads is compared with that in Timoshenko's beam.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <numbers>

#include "geometry/primitives.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "organ/organ.h"
#include "organ/tissue_cells.h"
#include "support/beams.h"
#include "support/figures.h"
#include "support/references/relax.h"
#include "support/tissue_blocks.h"

using namespace resect;

namespace {

constexpr double kSpacing = 0.005;

struct Force {
  std::int64_t cell;
  double along, beside, size;  // place along the beam and beside its axis, m; force across it, N
};

// Takes the net force and the net moments away.
void balance(std::vector<Force>& forces) {
  Mat3 sums = Mat3::Zero();
  Vec3 net = Vec3::Zero();
  for (const Force& f : forces) {
    const Vec3 one(1, f.along, f.beside);
    sums += one * one.transpose();
    net += f.size * one;
  }
  const Vec3 excess = sums.inverse() * net;
  for (Force& f : forces) f.size -= excess.dot(Vec3(1, f.along, f.beside));
}

// Twice the energy that the forces store in Timoshenko's beam, J.
double workInTheory(std::vector<Force> forces, const test::BeamSection& b, double length) {
  std::ranges::sort(forces, {}, &Force::along);
  constexpr int kParts = 4000;
  double work = 0, shear = 0, turning = 0;
  std::size_t next = 0;
  for (int k = 0; k < kParts; ++k) {
    const double s = length * ((k + 0.5) / kParts - 0.5);
    for (; next < forces.size() && forces[next].along < s; ++next) {
      shear += forces[next].size;
      turning += forces[next].size * forces[next].along;
    }
    const double moment = shear * s - turning;
    work += (moment * moment / b.bending() + shear * shear / b.shearing()) * length / kParts;
  }
  return work;
}

// Stiffness of a beam of height x 4 cells, turned by `turn` and shifted in the lattice, over that
// of Timoshenko's.
double stiffness(int height, const Eigen::Quaterniond& turn, const Vec3& shift,
                 bool boundary = true) {
  // Wider than high: a free beam rolls over until it bends where it is weakest.
  const test::BeamSection b{height * kSpacing, 1.25 * height * kSpacing, 5000, 0.3};
  const double length = 12 * b.height;
  const Vec3 half = 0.5 * Vec3(length, b.height, b.width);
  const TriangleMesh mesh = transformed(boxMesh({-half, half}), {Vec3::Zero(), turn});
  Lattice lattice = latticeForSpacing(bounds(mesh).padded(kSpacing), kSpacing);
  lattice.origin += kSpacing * shift;
  Discretization cells = discretize(mesh, lattice);
  fitSurface(mesh, cells);
  TissueCells solid = tissueCells(cells, test::material(b.young, b.poisson));
  if (!boundary) solid.share.clear(), solid.owner.clear();
  ElasticTissue tissue(solid, test::weightless());

  const Vec3 across = turn * Vec3::UnitY();
  std::vector<Force> forces;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    const Vec3 place = turn.conjugate() * lattice.centre(at);
    const double load = std::cos(2 * std::numbers::pi * place.x() / length);
    forces.push_back({c, place.x(), place.z(), load * particleVolume(cells, c)});
  });
  balance(forces);
  // As large as bends the beam by a hundredth of its length.
  const double size = std::sqrt(workInTheory(forces, b, length));
  double sum = 0;
  for (const Force& f : forces) sum += std::abs(f.size);
  for (Force& f : forces) f.size *= 0.01 * length * sum / (size * size);
  for (const Force& f : forces) tissue.setLoad(f.cell, f.size * across);
  CHECK(test::relax(tissue) < 40000);
  double work = 0;
  for (const Force& f : forces) work += f.size * across.dot(tissue.displacement(f.cell));
  return workInTheory(forces, b, length) / work;
}

Eigen::Quaterniond turned(double degrees, const Vec3& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()));
}

}  // namespace

TEST_CASE("beams of 4, 6 and 8 cells are as stiff in any direction of the lattice") {
  test::Figures figures("turned beams");
  const auto check = [&](int height, const std::string& name, const Eigen::Quaterniond& turn,
                         const Vec3& shift) {
    const double measured = stiffness(height, turn, shift);
    MESSAGE(height << " cells, " << name << ": " << measured);
    CHECK(figures.add(fmt::format("{} cells, {}: stiffness over theory", height, name), measured, 1,
                      0.05) < 0.05);
  };
  for (const int height : {4, 6, 8}) {
    check(height, "turned 30 degrees", turned(30, {0, 0, 1}), Vec3::Zero());
    check(height, "turned 15 degrees, shifted", turned(15, {0, 0, 1}), {0.5, 0.3, 0});
    check(height, "turned 40 degrees about (1, 1, 1)", turned(40, {1, 1, 1}), {0.2, 0.1, 0.4});
  }
  // Without boundary cells the same beam is too soft.
  const double bare = stiffness(4, turned(30, {0, 0, 1}), Vec3::Zero(), false);
  MESSAGE("4 cells, turned 30 degrees, without boundary cells: " << bare);
  CHECK(bare < 0.85);
}

// What can be read off elastic tissue: deformation, stress, force and energy, in double precision.
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "tissue/elastic_tissue.h"

namespace resect {
namespace {

Vec3 at(const std::array<FloatArray, 3>& field, std::int32_t i) {
  return {field[0][i], field[1][i], field[2][i]};
}

Mat3 inverseMoment(const ElasticState& s, std::int32_t i) {
  const auto& l = s.inverseMoment;
  Mat3 m;
  m << l[0][i], l[3][i], l[4][i], l[3][i], l[1][i], l[5][i], l[4][i], l[5][i], l[2][i];
  return m;
}

// H = F - I.
Mat3 gradient(const ElasticState& s, std::int32_t i) {
  const std::array<double, 4> weights = bondWeights();
  Mat3 sum = Mat3::Zero();
  for (int d = 0; d < kDirections; ++d)
    if (s.bonds[i] >> d & 1)
      sum += weights[neighbourKind(d)] * (at(s.u, i + s.box.step[d]) - at(s.u, i)) *
             offsetOf(d).cast<double>().transpose();
  return sum * inverseMoment(s, i) / s.spacing;
}

// visit.operator()<D>() for every direction, so that its offsets are known when compiling.
template <typename Visit>
void forEachDirection(const Visit& visit) {
  [&]<int... D>(std::integer_sequence<int, D...>) { (visit.template operator()<D>(), ...); }
  (std::make_integer_sequence<int, kDirections>{});
}

Mat3 cofactors(const Mat3& f) {
  Mat3 c;
  c.row(0) = f.row(1).cross(f.row(2));
  c.row(1) = f.row(2).cross(f.row(0));
  c.row(2) = f.row(0).cross(f.row(1));
  return c;
}

}  // namespace

Mat3 ElasticTissue::deformation(std::int64_t cell) const {
  return Mat3::Identity() + gradient(state_, state_.box.fromLattice(cell));
}

typedef float Four __attribute__((vector_size(16)));  // a vector of three

void ElasticTissue::place(std::span<const std::int64_t> cells,
                          std::span<CellPlacement> places) const {
  const ElasticState& s = state_;
  const std::array<double, 4> weights = bondWeights();
  std::array<float, 4> weight{};
  for (int kind = 1; kind <= 3; ++kind) weight[kind] = float(weights[kind] / s.spacing);
  parallelFor(cells.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::int32_t i = s.box.fromLattice(cells[n]);
      const Four u = {s.u[0][i], s.u[1][i], s.u[2][i], 0};
      Four along[3] = {};
      const std::uint32_t bonds = s.bonds[i];
      forEachDirection([&]<int D>() {
        if (!(bonds >> D & 1)) return;
        const std::int32_t j = i + s.box.step[D];
        const Four wu = weight[neighbourKind(D)] * (Four{s.u[0][j], s.u[1][j], s.u[2][j], 0} - u);
        for (int a = 0; a < 3; ++a) {
          if (offsetAlong(D, a) > 0) along[a] += wu;
          if (offsetAlong(D, a) < 0) along[a] -= wu;
        }
      });
      Eigen::Matrix3f sum;
      sum << Vec3f(along[0][0], along[0][1], along[0][2]),
          Vec3f(along[1][0], along[1][1], along[1][2]),
          Vec3f(along[2][0], along[2][1], along[2][2]);
      places[n] = {Vec3f(u[0], u[1], u[2]), sum * inverseMoment(s, i).cast<float>()};
    }
  });
}

Mat3 ElasticTissue::stress(std::int64_t cell) const {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (state_.kappa[i] == 0) return Mat3::Zero();
  const TissueMaterial& m = state_.materials[state_.material[i]];
  const Mat3 f = deformation(cell), cof = cofactors(f);
  const double limit = std::min(1.0, kMostStiffening / cof.squaredNorm());
  return m.shear() * (f - cof) + limit * (m.lame() + m.shear()) * (f.determinant() - 1) * cof;
}

Vec3 ElasticTissue::elasticForce(std::int64_t cell) const {
  const std::int32_t i = state_.box.fromLattice(cell);
  const std::array<double, 4> weights = bondWeights();
  const auto stressAt = [&](std::int32_t j) {
    Mat3 a;
    for (int k = 0; k < 9; ++k) a(k / 3, k % 3) = state_.stress[k][j];
    return a;
  };
  Vec3 force = stressAt(i) * at(state_.skew, i);
  for (int d = 0; d < kDirections; ++d)
    if (state_.bonds[i] >> d & 1)
      force +=
          weights[neighbourKind(d)] * stressAt(i + state_.box.step[d]) * offsetOf(d).cast<double>();
  return force / state_.spacing + at(state_.bondForce, i);
}

TissueEnergy ElasticTissue::energy() {
  settleEdits();
  const std::array<double, 4> weights = bondWeights();
  const double s = state_.spacing, volume = s * s * s;
  TissueEnergy sum;
  for (const TissueChunk& chunk : state_.chunks)
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i) {
      if (!state_.solid[i]) continue;
      const double mass = 1 / double(state_.inverseMass[i]);
      sum.kinetic += 0.5 * mass * at(state_.v, i).squaredNorm();
      sum.gravity -= mass * settings_.gravity.dot(at(state_.u, i));
      if (state_.kappa[i] == 0) continue;
      const TissueMaterial& m = state_.materials[state_.material[i]];
      const Mat3 h = gradient(state_, i), f = h + Mat3::Identity();
      const double growth = f.determinant() - 1;
      sum.elastic += volume * (m.shear() / 2 * (f.squaredNorm() - 3) - m.shear() * growth +
                               (m.lame() + m.shear()) / 2 * growth * growth);
      double misfit = 0;
      for (int d = 0; d < kDirections; ++d)
        if (state_.bonds[i] >> d & 1)
          misfit += weights[neighbourKind(d)] / (s * s) *
                    (s * (h * offsetOf(d).cast<double>()) -
                     (at(state_.u, i + state_.box.step[d]) - at(state_.u, i)))
                        .squaredNorm();
      sum.elastic += state_.kappa[i] / 2 * misfit;
    }
  sum.elastic += threadEnergy(threads_, state_);
  return sum;
}

}  // namespace resect

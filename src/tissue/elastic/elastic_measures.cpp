// Measures of elastic tissue in double precision: deformation, stress, force, energy.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "tissue/elastic/capsule.h"
#include "tissue/elastic/elastic_tissue.h"
#include "tissue/elastic/gradient.h"

namespace resect {
namespace {

Vec3 at(const std::array<FloatArray, 3>& field, std::int32_t i) {
  return {field[0][i], field[1][i], field[2][i]};
}

// F:F - 3 - 2 (J - 1).
double distortion(const Mat3& f) { return f.squaredNorm() - 3 - 2 * (f.determinant() - 1); }

// By how much the shear modulus has grown. limit: of the response to volume change.
double hardening(const TissueMaterial& m, const Mat3& f, double limit) {
  return std::clamp(limit * limit * m.stiffening * distortion(f), 0.0, double(kMostStiffening));
}

// I + B of a Maxwell branch.
Mat3 eased(const ElasticState& s, std::size_t branch, std::int32_t i) {
  const auto& b = s.relaxed[branch];
  Mat3 m;
  m << b[0][i], b[3][i], b[4][i], b[3][i], b[1][i], b[5][i], b[4][i], b[5][i], b[2][i];
  return Mat3::Identity() + m;
}

}  // namespace

double freeEnergy(const ElasticState& s, std::int32_t i, const Mat3& f) {
  const TissueMaterial& m = s.materials[s.material[i]];
  const double growth = f.determinant() - 1;
  double sum = heldEnergy(m, f) + m.viscousShear() / 6 * growth * growth;
  for (std::size_t k = 0; k < m.branches.size(); ++k)
    sum += m.branches[k].share * m.shear() / 2 *
           ((f * eased(s, k, i)).cwiseProduct(f).sum() - 3 - 2 * growth);
  return sum;
}

Mat3 ElasticTissue::deformation(std::int64_t cell) const {
  return Mat3::Identity() + gradientAt(state_, state_.box.fromLattice(cell));
}

// Consecutive cells of the list that lie in one chunk are processed together.
void ElasticTissue::place(std::span<const std::int64_t> cells,
                          std::span<CellPlacement> places) const {
  ElasticState& state = const_cast<ElasticState&>(state_);  // a view is also for writing
  const ElasticView view = viewOf(state);
  const std::array<double, 4> weights = edgeWeights();
  const float weight[4] = {0, float(weights[1]), float(weights[2]), float(weights[3])};
  parallelFor(cells.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end;) {
      const std::int32_t start = state_.box.fromLattice(cells[n]) / kChunk * kChunk;
      std::int32_t lane[kChunk];
      std::uint32_t wanted = 0;
      std::size_t last = n;
      for (; last < end && last - n < kChunk; ++last) {
        const std::int32_t at = state_.box.fromLattice(cells[last]) - start;
        if (at < 0 || at >= kChunk) break;
        lane[last - n] = at;
        wanted |= 1u << at;
      }
      float found[12][kChunk];
      kernel_->placements(view, weight, start, wanted, found);
      for (std::size_t first = n; n < last; ++n) {
        const std::int32_t at = lane[n - first];
        CellPlacement& to = places[n];
        to.displacement = {found[0][at], found[1][at], found[2][at]};
        for (int k = 0; k < 9; ++k) to.gradient(k / 3, k % 3) = found[3 + k][at];
      }
    }
  });
}

Mat3 ElasticTissue::stress(std::int64_t cell) const {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (state_.kappa[i] == 0) return Mat3::Zero();
  const TissueMaterial& m = state_.materials[state_.material[i]];
  const Mat3 f = deformation(cell), cof = cofactors(f);
  const double limit =
      std::min(1.0, double(constants(longestSubstep_).cofactorLimit) / cof.squaredNorm());
  const double bulk = m.lame() + m.shear() + m.viscousShear() / 3, growth = f.determinant() - 1;
  Mat3 stress = m.shear() * (1 + hardening(m, f, limit)) * (f - cof) + limit * bulk * growth * cof;
  stress +=
      f * capsuleResponse(state_, i, f).stress / (state_.spacing * state_.spacing * state_.spacing);
  for (std::size_t k = 0; k < m.branches.size(); ++k)
    stress += limit * m.branches[k].share * m.shear() * (f * eased(state_, k, i) - cof);
  return stress;
}

Vec3 ElasticTissue::elasticForce(std::int64_t cell) const {
  const std::int32_t i = state_.box.fromLattice(cell);
  const std::array<double, 4> weights = edgeWeights();
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
  return force + at(state_.bondForce, i);
}

TissueEnergy ElasticTissue::energy() {
  settle();
  const std::array<double, 4> weights = bondWeights();
  const double s = state_.spacing, volume = s * s * s;
  TissueEnergy sum;
  for (const TissueChunk& chunk : state_.chunks)
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i) {
      if (!state_.solid[i]) continue;
      const double mass = 1 / double(state_.inverseMass[i]);
      sum.kinetic += 0.5 * mass * at(state_.v, i).squaredNorm();
      sum.gravity -= mass * double(state_.weight[i]) * settings_.gravity.dot(at(state_.u, i));
      if (state_.kappa[i] == 0) continue;
      const Mat3 h = gradientAt(state_, i), f = h + Mat3::Identity();
      sum.elastic += double(state_.share[i]) * volume * freeEnergy(state_, i, f);
      sum.elastic += capsuleResponse(state_, i, f).energy;
      double misfit = 0;
      for (int d = 0; d < kDirections; ++d) {
        if (!(state_.bonds[i] >> d & 1)) continue;
        const Vec3 apart = (at(state_.u, i + state_.box.step[d]) - at(state_.u, i)) / s;
        misfit += weights[neighbourKind(d)] * apart.dot(apart - h * offsetOf(d).cast<double>());
      }
      sum.elastic += state_.kappa[i] / 2 * misfit;
    }
  sum.elastic += fibreEnergy(fibres_, state_) + cordEnergy(cords_, state_);
  return sum;
}

}  // namespace resect

#include "tissue/elastic/capsule.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "tissue/elastic/elastic_setup.h"
#include "tissue/elastic/gradient.h"

namespace resect {
namespace {

// Largest skin area times sensitivity that a cell may have. It is 1.9 for a cell of a flat face
// along the lattice, and 2 to 4 elsewhere. A few cells, of thin margins and beside cuts, have up
// to 10. The substep of all cells would have to be shorter for them, so their capsule is made
// softer.
constexpr double kMostStiff = 4;

// Distance from a wound at which the capsule does not draw back any more, m.
constexpr double kReach = 0.06;

// How strongly the strain of a cell depends on the displacements of its neighbours and itself:
// sum of |dH/du|^2, 1/m^2.
double sensitivity(const ElasticState& s, std::int32_t i) {
  const std::array<double, 4> weights = edgeWeights();
  const Mat3 inverse = inverseMomentAt(s, i);
  Vec3 own = Vec3::Zero();
  double sum = 0;
  for (int d = 0; d < kDirections; ++d) {
    if (!(s.bonds[i] >> d & 1)) continue;
    const Vec3 slope = weights[neighbourKind(d)] * inverse * offsetOf(d).cast<double>();
    own += slope;
    sum += slope.squaredNorm();
  }
  return sum + own.squaredNorm();
}

// Principal stretches minus 1 and tensions, N/m, of a membrane; the larger ones first. energy: per
// area, J/m^2. tightness: ElasticState::tightness.
struct Stretched {
  double d[2];
  double tension[2];
  double energy;
};
Stretched stretched(double stiffness, double e1, double e2, double tightness) {
  constexpr double kNu = kCapsulePoisson, kBoth = kBothWays;
  const auto longer = [](double e) { return 2 * e / (1 + std::sqrt(std::max(0.0, 1 + 2 * e))); };
  Stretched s{{longer(e1), longer(e2)}, {}, 0};
  const double x[2] = {s.d[0] + tightness, s.d[1] + tightness};
  s.tension[0] = stiffness * std::max({0.0, x[0], kBoth * (x[0] + kNu * x[1])});
  s.tension[1] = stiffness * std::max(0.0, kBoth * (x[1] + kNu * x[0]));
  s.energy = 0.5 * (s.tension[0] * x[0] + s.tension[1] * x[1]);  // tensions are linear in x
  return s;
}

// The tightness at which a membrane has the tension of the intact organ in both directions.
double tightnessOf(const TissueMaterial& m) {
  return m.capsule > 0 ? m.capsuleTension / (m.capsule * kBothWays * (1 + kCapsulePoisson)) : 0;
}

bool endsAtWound(const ElasticState& s, std::int32_t i) {
  if (!s.solid[i] || !(s.skinArea[i] > 0)) return false;
  for (int d = 0; d < kDirections; ++d) {
    const std::int32_t j = i + s.box.step[d];
    if (s.solid[j] ? !(s.bonds[i] >> d & 1) : s.skinArea[j] > 0) return true;
  }
  return false;
}

// What a wound's lip at the place `at` gives cell i, whose place is `c`; below 0 beyond kReach.
float tightnessBy(const ElasticState& s, std::int32_t i, const Vec3i& c, const Vec3i& at) {
  const double share = 1 - s.spacing * (c - at).cast<double>().norm() / kReach;
  return float(share * tightnessOf(s.materials[s.material[i]]));
}

float tightnessAt(const ElasticState& s, std::int32_t i) {
  float most = 0;
  for (const std::int32_t lip : s.lips)
    most = std::max(most, tightnessBy(s, i, s.box.cell(i), s.box.cell(lip)));
  return most;
}

void tightenRound(ElasticState& s, std::int32_t lip) {
  const Vec3i reach = Vec3i::Constant(int(kReach / s.spacing)), at = s.box.cell(lip);
  const Vec3i low = (at - reach).cwiseMax(0);
  const Vec3i high = (at + reach).cwiseMin(s.box.dims - Vec3i::Ones());
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const Vec3i c(x, y, z);
        const std::int32_t i = s.box.index(c);
        if (s.skinArea[i] > 0) s.tightness[i] = std::max(s.tightness[i], tightnessBy(s, i, c, at));
      }
}

}  // namespace

void setSkin(ElasticState& s, std::span<const SurfacePatch> patches) {
  const bool any =
      std::ranges::any_of(s.materials, [](const TissueMaterial& m) { return m.capsule > 0; });
  if (!any) return;
  for (FloatArray& component : s.skinNormal) component.assign(s.box.size, 0);
  s.skinArea.assign(s.box.size, 0);
  s.capsule.assign(s.box.size, 0);
  s.tightness.assign(s.box.size, 0);
  s.lips.clear();
  allocateBranches(s);
  std::vector<std::int32_t> cells;
  for (std::size_t k = 0; k < patches.size();) {
    const std::int64_t cell = patches[k].cell;
    // Of a thin margin both faces count, though their normals are opposite.
    Mat3 sum = Mat3::Zero();
    for (; k < patches.size() && patches[k].cell == cell; ++k) {
      const Vec3 area = patches[k].area.cast<double>();
      if (area.norm() > 0) sum += area * area.transpose() / area.norm();
    }
    const std::int32_t i = s.box.fromLattice(cell);
    if (!s.solid[i]) continue;
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(sum);
    for (int a = 0; a < 3; ++a) s.skinNormal[a][i] = float(eigen.eigenvectors()(a, 2));
    s.skinArea[i] = float(eigen.eigenvalues()[2]);
    cells.push_back(i);
  }
  remakeCapsule(s, cells);
  refreshChunks(s, cells);
}

void remakeCapsule(ElasticState& s, std::span<const std::int32_t> cells) {
  if (s.capsule.empty()) return;
  for (const std::int32_t i : cells) {
    s.capsule[i] = 0;
    if (!s.solid[i] || s.capsuleTorn[i] || !(s.skinArea[i] > 0)) continue;
    const double most = kMostStiff / sensitivity(s, i);
    s.capsule[i] =
        float(s.materials[s.material[i]].capsule * std::min(double(s.skinArea[i]), most));
  }
}

void retractCapsule(ElasticState& s, std::span<const std::int32_t> cells) {
  const bool any = std::ranges::any_of(
      s.materials, [](const TissueMaterial& m) { return m.capsuleTension > 0; });
  if (s.capsule.empty() || !any) return;
  std::vector<std::int32_t> fresh;
  for (const std::int32_t i : cells) {
    const auto at = std::ranges::lower_bound(s.lips, i);
    const bool was = at != s.lips.end() && *at == i, is = endsAtWound(s, i);
    if (is && !was) s.lips.insert(at, i), fresh.push_back(i);
    if (was && !is) s.lips.erase(at), fresh = s.lips, s.tightness.assign(s.box.size, 0);
  }
  for (const std::int32_t lip : fresh) tightenRound(s, lip);
  for (const std::int32_t i : cells)  // whose material may have changed
    if (s.skinArea[i] > 0) s.tightness[i] = tightnessAt(s, i);
}

CapsuleResponse capsuleResponse(const ElasticState& s, std::int32_t i, const Mat3& f) {
  CapsuleResponse response;
  if (s.capsule.empty() || !(s.capsule[i] > 0)) return response;
  const Vec3 normal(s.skinNormal[0][i], s.skinNormal[1][i], s.skinNormal[2][i]);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = normal.unitOrthogonal();
  tangents.col(1) = normal.cross(tangents.col(0));
  const Eigen::Matrix<double, 3, 2> g = f * tangents;
  const Eigen::Matrix2d strain = 0.5 * (g.transpose() * g - Eigen::Matrix2d::Identity());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(strain);
  const double stiffness = s.materials[s.material[i]].capsule;
  const double area = double(s.capsule[i]) / stiffness;  // that counts
  const double tightness = s.tightness[i];
  const Stretched at =
      stretched(stiffness, eigen.eigenvalues()[1], eigen.eigenvalues()[0], tightness);
  response.tension = at.tension[0];
  response.energy = area * (at.energy - stretched(stiffness, 0, 0, tightness).energy);
  for (int k = 0; k < 2; ++k) {
    const Vec3 along = tangents * eigen.eigenvectors().col(1 - k);
    response.stress += area * at.tension[k] / (1 + at.d[k]) * along * along.transpose();
  }
  return response;
}

void tearCapsule(ElasticState& s, const ElasticKernel& kernel) {
  if (s.capsule.empty()) return;
  ChunkGradients gradients(s, kernel);
  for (const TissueChunk& chunk : s.chunks) {
    if (!chunk.skin) continue;
    for (int k = chunk.first; k <= chunk.last; ++k) {
      const std::int32_t i = chunk.start + k;
      if (!(s.capsule[i] > 0)) continue;
      const Mat3 h = gradients.at(i);
      const TissueMaterial& m = s.materials[s.material[i]];
      // A stretch is at most 1 + |H|: most cells need no eigenvalues.
      if (2 * m.capsule * (h.norm() + double(s.tightness[i])) < m.capsuleStrength) continue;
      if (capsuleResponse(s, i, Mat3::Identity() + h).tension <= m.capsuleStrength) continue;
      s.capsuleTorn[i] = 1;
      s.capsule[i] = 0;
    }
  }
}

}  // namespace resect

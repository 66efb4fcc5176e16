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

// Principal stretches minus 1 and tensions, N/m, of a membrane; the larger ones first.
struct Stretched {
  double d[2];
  double tension[2];
};
Stretched stretched(double stiffness, double e1, double e2) {
  constexpr double kNu = kCapsulePoisson, kBoth = kBothWays;
  const auto longer = [](double e) { return 2 * e / (1 + std::sqrt(std::max(0.0, 1 + 2 * e))); };
  Stretched s{{longer(e1), longer(e2)}, {}};
  s.tension[0] = stiffness * std::max({0.0, s.d[0], kBoth * (s.d[0] + kNu * s.d[1])});
  s.tension[1] = stiffness * std::max(0.0, kBoth * (s.d[1] + kNu * s.d[0]));
  return s;
}

}  // namespace

void setSkin(ElasticState& s, std::span<const SurfacePatch> patches) {
  const bool any =
      std::ranges::any_of(s.materials, [](const TissueMaterial& m) { return m.capsule > 0; });
  if (!any) return;
  for (FloatArray& component : s.skinNormal) component.assign(s.box.size, 0);
  s.skinArea.assign(s.box.size, 0);
  s.capsule.assign(s.box.size, 0);
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
  const Stretched at = stretched(stiffness, eigen.eigenvalues()[1], eigen.eigenvalues()[0]);
  response.tension = at.tension[0];
  for (int k = 0; k < 2; ++k) {
    const Vec3 along = tangents * eigen.eigenvectors().col(1 - k);
    response.stress += area * at.tension[k] / (1 + at.d[k]) * along * along.transpose();
    response.energy += area * 0.5 * at.tension[k] * at.d[k];  // tensions are linear in d
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
      if (2 * m.capsule * h.norm() < m.capsuleStrength) continue;
      if (capsuleResponse(s, i, Mat3::Identity() + h).tension <= m.capsuleStrength) continue;
      s.capsuleTorn[i] = 1;
      s.capsule[i] = 0;
    }
  }
}

}  // namespace resect

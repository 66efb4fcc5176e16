#include "support/references/thesis_method.h"

#include <algorithm>

#include "isosurface/marching_cubes_table.h"
#include "sph/kernel.h"

namespace resect::test {

double ThesisMethod::getLevelSet(std::span<const ThesisParticle> particles, const Vec3& r) const {
  double sum = 0;
  for (const ThesisParticle& p : particles)
    sum += p.volume * p.colour * kernel((r - p.position).norm(), h_);
  return sum;
}

double ThesisMethod::getLevelSetNear(std::span<const ThesisParticle> particles,
                                     const Vec3& r) const {
  const double support = kKernelSupport * h_;
  double sum = 0;
  for (const ThesisParticle& p : particles) {
    const double square = (r - p.position).squaredNorm();
    if (square < support * support) sum += p.volume * p.colour * kernel(std::sqrt(square), h_);
  }
  return sum;
}

ThesisSurface ThesisMethod::update(std::span<const ThesisParticle> particles, bool passOverFar,
                                   StageClock* clock) {
  const auto done = [&](const char* function) {
    if (clock) clock->lap(function);
  };
  if (clock) clock->start();
  const Vec3 spacing = grid_.spacing();
  field_.resize(grid_.count());
  for (int z = 0; z < grid_.nodes.z(); ++z)
    for (int y = 0; y < grid_.nodes.y(); ++y)
      for (int x = 0; x < grid_.nodes.x(); ++x) {
        const Vec3 r = grid_.box.min + spacing.cwiseProduct(Vec3(x, y, z));
        field_[node(x, y, z)] =
            passOverFar ? getLevelSetNear(particles, r) : getLevelSet(particles, r);
      }
  done("getLevelSet");
  calcGradients();
  done("calcGradients");
  ThesisSurface surface = calcPoints();
  done("calcPoints");
  return surface;
}

void ThesisMethod::calcGradients() {
  const Vec3 spacing = grid_.spacing();
  const Vec3i n = grid_.nodes;
  gradients_.resize(field_.size());
  for (int z = 0; z < n.z(); ++z)
    for (int y = 0; y < n.y(); ++y)
      for (int x = 0; x < n.x(); ++x) {
        const auto slope = [&](int axis) {
          Vec3i low(x, y, z), high(x, y, z);
          low[axis] = std::max(low[axis] - 1, 0);
          high[axis] = std::min(high[axis] + 1, n[axis] - 1);
          return (field_[node(high.x(), high.y(), high.z())] -
                  field_[node(low.x(), low.y(), low.z())]) /
                 ((high[axis] - low[axis]) * spacing[axis]);
        };
        gradients_[node(x, y, z)] = Vec3(slope(0), slope(1), slope(2));
      }
}

ThesisSurface ThesisMethod::calcPoints() const {
  const Vec3 spacing = grid_.spacing();
  const Vec3i n = grid_.nodes;
  const auto& table = marchingCubesTable();
  ThesisSurface surface;
  // The point on each node's three upward edges, made when a cell first asks for it.
  std::vector<std::array<std::int32_t, 3>> pointOf(field_.size(), {-1, -1, -1});
  for (int z = 0; z + 1 < n.z(); ++z)
    for (int y = 0; y + 1 < n.y(); ++y)
      for (int x = 0; x + 1 < n.x(); ++x) {
        int inside = 0;
        for (int c = 0; c < 8; ++c)
          if (field_[node(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))] >= iso_) inside |= 1 << c;
        const CellTriangles& cell = table[inside];
        for (int t = 0; t < cell.count; ++t) {
          Triangle triangle;
          for (int v = 0; v < 3; ++v) {
            const CellEdge edge = kCellEdges[cell.edges[t][v]];
            const Vec3i from(x + (edge.from & 1), y + (edge.from >> 1 & 1), z + (edge.from >> 2));
            const Vec3i to = from + Vec3i::Unit(edge.axis);
            const std::size_t a = node(from.x(), from.y(), from.z());
            const std::size_t b = node(to.x(), to.y(), to.z());
            std::int32_t& point = pointOf[a][edge.axis];
            if (point < 0) {
              const double share = (iso_ - field_[a]) / (field_[b] - field_[a]);
              Vec3 where = from.cast<double>();
              where[edge.axis] += share;
              const Vec3 slope = (1 - share) * gradients_[a] + share * gradients_[b];
              point = std::int32_t(surface.mesh.points.size());
              surface.mesh.points.push_back(grid_.box.min + spacing.cwiseProduct(where));
              surface.normals.push_back(-slope.normalized());
            }
            triangle[v] = point;
          }
          surface.mesh.triangles.push_back(triangle);
        }
      }
  return surface;
}

}  // namespace resect::test

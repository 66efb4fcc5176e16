#include "organ/skin.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace resect {
namespace {

constexpr std::size_t kGrain = 2048;  // vertices per block

}  // namespace

std::int32_t SurfaceSkin::placeOf(std::int64_t cell) {
  std::int32_t& place = placeOfCell_[cell];
  if (place < 0) {
    place = std::int32_t(cells_.size());
    cells_.push_back(cell);
  }
  return place;
}

void SurfaceSkin::bind(const Vec3f& vertex, const Lattice& lattice, const TissueModel& tissue,
                       Binding& to) {
  to.place.fill(-1);
  to.weight.fill(0);
  const Vec3 at = lattice.toCellSpace(vertex.cast<double>());
  struct Candidate {
    Vec3i cell;
    double weight;
  };
  std::array<Candidate, 8> candidates;
  int count = 0;
  const Vec3i low = at.array().floor().cast<int>();
  const Vec3 f = at - low.cast<double>();
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3i cell = low + Vec3i(corner & 1, corner >> 1 & 1, corner >> 2);
    if (!lattice.contains(cell) || !tissue.solid(lattice.index(cell))) continue;
    double weight = 1;
    for (int a = 0; a < 3; ++a) weight *= cell[a] > low[a] ? f[a] : 1 - f[a];
    candidates[count++] = {cell, weight + 1e-6};
  }
  if (count == 0) {
    // A thin edge of skin: the nearest particle within two cells.
    double nearest = 1e9;
    for (int dz = -2; dz <= 3; ++dz)
      for (int dy = -2; dy <= 3; ++dy)
        for (int dx = -2; dx <= 3; ++dx) {
          const Vec3i cell = low + Vec3i(dx, dy, dz);
          if (!lattice.contains(cell) || !tissue.solid(lattice.index(cell))) continue;
          const double distance = (at - cell.cast<double>()).squaredNorm();
          if (distance >= nearest) continue;
          nearest = distance;
          candidates[0] = {cell, 1};
          count = 1;
        }
    if (count == 0) return;
  }
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += candidates[i].weight;
  for (int i = 0; i < count; ++i) {
    to.place[i] = placeOf(lattice.index(candidates[i].cell));
    to.weight[i] = float(candidates[i].weight / sum);
  }
}

void SurfaceSkin::follow(const SurfaceTracker& surface, const Lattice& lattice,
                         const TissueModel& tissue, std::span<const std::int64_t> changedCells) {
  if (placeOfCell_.empty()) placeOfCell_.assign(lattice.cellCount(), -1);
  const std::span<const Vec3f> rest = surface.points();
  const std::size_t before = bindings_.size();
  bindings_.resize(rest.size());
  points_.resize(rest.size());
  normals_.resize(rest.size());

  if (!changedCells.empty()) {
    changed_.assign(cells_.size(), 0);
    for (const std::int64_t cell : changedCells)
      if (placeOfCell_[cell] >= 0) changed_[placeOfCell_[cell]] = 1;
    for (std::size_t v = 0; v < before; ++v)
      for (const std::int32_t place : bindings_[v].place)
        if (place >= 0 && place < std::int32_t(changed_.size()) && changed_[place]) {
          bind(rest[v], lattice, tissue, bindings_[v]);
          break;
        }
  }
  if (surface.changes().everything || before == 0) {
    for (std::size_t v = 0; v < rest.size(); ++v) bind(rest[v], lattice, tissue, bindings_[v]);
  } else {
    for (const IndexRange& range : surface.changes().vertices)
      for (std::int32_t v = range.first; v < range.first + range.count; ++v)
        bind(rest[v], lattice, tissue, bindings_[v]);
  }
  // Beside a wound the tracker knows which particles are on a vertex's side.
  if (surface.changes().everything || !surface.changes().vertices.empty())
    surface.visitBindings([&](std::int32_t first, std::span<const VertexBinding> bindings) {
      for (std::size_t v = 0; v < bindings.size(); ++v) {
        Binding& to = bindings_[std::size_t(first) + v];
        if (bindings[v].count == 0) continue;
        to.place.fill(-1);
        to.weight.fill(0);
        for (int k = 0; k < bindings[v].count; ++k) {
          if (!tissue.solid(bindings[v].cell[k])) continue;
          to.place[k] = placeOf(bindings[v].cell[k]);
          to.weight[k] = bindings[v].weight[k];
        }
      }
    });

  for (std::size_t i = restOfCell_.size(); i < cells_.size(); ++i)
    restOfCell_.push_back(lattice.centre(lattice.cell(cells_[i])).cast<float>());
  placements_.resize(cells_.size());
  tissue.place(cells_, placements_);
  const std::span<const Vec3f> restNormals = surface.normals();
  parallelFor(rest.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Binding& binding = bindings_[v];
      Vec3f u = Vec3f::Zero();
      Eigen::Matrix3f gradient = Eigen::Matrix3f::Zero();
      for (int k = 0; k < 8; ++k) {
        if (binding.place[k] < 0) continue;
        const CellPlacement& cell = placements_[binding.place[k]];
        const float w = binding.weight[k];
        u += w * (cell.displacement + cell.gradient * (rest[v] - restOfCell_[binding.place[k]]));
        gradient += w * cell.gradient;
      }
      points_[v] = rest[v] + u;
      const Eigen::Matrix3f f = gradient + Eigen::Matrix3f::Identity();
      Eigen::Matrix3f cofactor;
      cofactor.row(0) = f.row(1).cross(f.row(2));
      cofactor.row(1) = f.row(2).cross(f.row(0));
      cofactor.row(2) = f.row(0).cross(f.row(1));
      const Vec3f normal = cofactor * restNormals[v];
      const float length = normal.norm();
      normals_[v] = length > 1e-20f ? Vec3f(normal / length) : restNormals[v];
    }
  });
}

std::size_t SurfaceSkin::bytes() const {
  return bindings_.capacity() * sizeof(Binding) + cells_.capacity() * sizeof(std::int64_t) +
         placeOfCell_.capacity() * sizeof(std::int32_t) +
         (restOfCell_.capacity() + points_.capacity() + normals_.capacity()) * sizeof(Vec3f) +
         placements_.capacity() * sizeof(CellPlacement) + changed_.capacity();
}

}  // namespace resect

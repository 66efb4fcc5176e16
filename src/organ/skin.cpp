#include "organ/skin.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace resect {
namespace {

constexpr std::size_t kGrain = 2048;  // vertices per block

}  // namespace

std::int32_t SurfaceSkin::entryOf(std::int64_t cell) {
  std::int32_t& entry = entryOfCell_[cell];
  if (entry < 0) {
    entry = std::int32_t(cells_.size());
    cells_.push_back(cell);
  }
  return entry;
}

SurfaceSkin::Binding SurfaceSkin::bind(const Vec3f& vertex, const Lattice& lattice,
                                       const TissueModel& tissue) {
  Binding to;
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
    // A thin edge without neighbouring particles: the nearest one within two cells.
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
    if (count == 0) return to;
  }
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += candidates[i].weight;
  for (int i = 0; i < count; ++i) {
    to.entry[i] = entryOf(lattice.index(candidates[i].cell));
    to.weight[i] = float(candidates[i].weight / sum);
  }
  return to;
}

void SurfaceSkin::findMotions(const Lattice& lattice, const TissueModel& tissue) {
  for (std::size_t i = restOfCell_.size(); i < cells_.size(); ++i)
    restOfCell_.push_back(lattice.centre(lattice.cell(cells_[i])).cast<float>());
  placements_.resize(cells_.size());
  motions_.resize(
      std::max<std::size_t>(1, cells_.size()));  // vertices without particles use the first entry
  tissue.place(cells_, placements_);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const auto& [displacement, gradient] = placements_[i];
    motions_[i] = particleMotion(restOfCell_[i], displacement, gradient);
  }
}

// Motions are averaged first and applied once: four vector products per particle.
ParticleMotion SurfaceSkin::motionOf(const Binding& binding) const {
  ParticleMotion mean;
  const auto blend = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      add(mean, binding.weight[k], motions_[std::size_t(binding.entry[k])]);
  };
  blend(0, 4);
  if (binding.weight[4] > 0) blend(4, 8);
  return mean;
}

void SurfaceSkin::movePoints(std::span<const Vec3f> rest) {
  parallelFor(rest.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Column moved = displacementAt(motionOf(bindings_[v]), rest[v]);
      points_[v] = rest[v] + Vec3f(moved[0], moved[1], moved[2]);
    }
  });
}

void SurfaceSkin::turnNormals(const SurfaceTracker& surface) {
  const std::span<const Vec3f> rest = surface.normals();
  normals_.resize(rest.size());
  const auto turn = [](Column v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); };  // y z x
  parallelFor(rest.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const ParticleMotion mean = motionOf(bindings_[v]);
      // The columns of cof F are the cross products of F's.
      const Column g0 = mean.gradient[0] + Column{1, 0, 0, 0};
      const Column g1 = mean.gradient[1] + Column{0, 1, 0, 0};
      const Column g2 = mean.gradient[2] + Column{0, 0, 1, 0};
      const Column t0 = turn(g0), t1 = turn(g1), t2 = turn(g2);
      const Vec3f& n = rest[v];
      const Column turned =
          n.x() * (g1 * t2 - t1 * g2) + n.y() * (g2 * t0 - t2 * g0) + n.z() * (g0 * t1 - t0 * g1);
      const Vec3f normal(turned[1], turned[2], turned[0]);
      const float length = normal.norm();
      normals_[v] = length > 1e-20f ? Vec3f(normal / length) : n;
    }
  });
}

void SurfaceSkin::follow(const SurfaceTracker& surface, const Lattice& lattice,
                         const TissueModel& tissue, std::span<const std::int64_t> changedCells,
                         bool withLook) {
  if (entryOfCell_.empty()) entryOfCell_.assign(lattice.cellCount(), -1);
  const std::span<const Vec3f> rest = surface.points();
  const std::size_t before = bindings_.size();
  bindings_.resize(rest.size());
  points_.resize(rest.size());

  if (!changedCells.empty()) {
    changed_.assign(cells_.size(), 0);
    for (const std::int64_t cell : changedCells)
      if (entryOfCell_[cell] >= 0) changed_[entryOfCell_[cell]] = 1;
    for (std::size_t v = 0; v < before; ++v)
      for (std::size_t k = 0; k < 8; ++k)
        if (bindings_[v].weight[k] > 0 && changed_[bindings_[v].entry[k]]) {
          bindings_[v] = bind(rest[v], lattice, tissue);
          break;
        }
  }
  if (surface.changes().everything || before == 0) {
    for (std::size_t v = 0; v < rest.size(); ++v) bindings_[v] = bind(rest[v], lattice, tissue);
  } else {
    for (const IndexRange& range : surface.changes().vertices)
      for (std::int32_t v = range.first; v < range.first + range.count; ++v)
        bindings_[v] = bind(rest[v], lattice, tissue);
  }
  // Beside a wound the tracker's bindings name the particles on a vertex's side.
  if (surface.changes().everything || !surface.changes().vertices.empty())
    surface.visitBindings([&](std::int32_t first, std::span<const VertexBinding> bindings) {
      for (std::size_t v = 0; v < bindings.size(); ++v) {
        Binding& to = bindings_[std::size_t(first) + v];
        if (bindings[v].count == 0) continue;
        to = {};
        for (int k = 0, count = 0; k < bindings[v].count; ++k) {
          if (!tissue.solid(bindings[v].cell[k])) continue;
          to.entry[count] = entryOf(bindings[v].cell[k]);
          to.weight[count++] = bindings[v].weight[k];
        }
      }
    });

  findMotions(lattice, tissue);
  movePoints(rest);
  if (withLook) turnNormals(surface);
}

std::size_t SurfaceSkin::bytes() const {
  return bindings_.capacity() * sizeof(Binding) + cells_.capacity() * sizeof(std::int64_t) +
         entryOfCell_.capacity() * sizeof(std::int32_t) +
         (restOfCell_.capacity() + points_.capacity() + normals_.capacity()) * sizeof(Vec3f) +
         placements_.capacity() * sizeof(CellPlacement) +
         motions_.capacity() * sizeof(ParticleMotion) + changed_.capacity();
}

}  // namespace resect

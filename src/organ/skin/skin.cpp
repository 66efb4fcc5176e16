#include "organ/skin/skin.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/parallel.h"
#include "organ/skin/bind_vertex.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

constexpr std::size_t kGrain = 2048;  // vertices per block
constexpr int kFewBonds = 13;         // a particle at an edge has so many; in a flat skin 17

// Whether so few bonds determine a particle's gradient that it may err.
bool isThin(std::uint32_t bonds) { return std::popcount(bonds) <= kFewBonds; }

}  // namespace

std::int32_t SurfaceSkin::entryOf(std::int64_t cell) {
  std::int32_t& entry = entryOfCell_[cell];
  if (entry < 0) {
    entry = std::int32_t(cells_.size());
    cells_.push_back(cell);
  }
  return entry;
}

// Particles that are gone are left out.
void SurfaceSkin::setBinding(std::size_t v, const VertexBinding& followed,
                             const TissueModel& tissue) {
  Binding& to = bindings_[v];
  to = {};
  for (int k = 0, count = 0; k < followed.count; ++k) {
    if (!tissue.solid(followed.cell[k])) continue;
    to.entry[count] = entryOf(followed.cell[k]);
    to.weight[count++] = followed.weight[k];
  }
}

// Marks the entries of cells_ whose particles are gone or came back, or have lost or regained
// bonds.
bool SurfaceSkin::markChanged(std::span<const std::int64_t> changedCells,
                              const TissueModel& tissue) {
  changed_.assign(cells_.size(), 0);
  bool any = false;
  const auto mark = [&](std::size_t entry) {
    changed_[entry] = 1;
    any = true;
  };
  for (const std::int64_t cell : changedCells)
    if (const std::int32_t entry = entryOfCell_[cell]; entry >= 0) mark(std::size_t(entry));
  for (std::size_t i = 0; i < bondsOfCell_.size(); ++i)
    if (const std::uint32_t bonds = tissue.bonds(cells_[i]); bonds != bondsOfCell_[i]) {
      bondsOfCell_[i] = bonds;
      mark(i);
    }
  return any;
}

// Whether the nearest particle is so far away that one that comes back may be nearer, although it
// shares no bond with it and its coming back does not touch the vertex's brick.
bool SurfaceSkin::followsFar(const Vec3f& rest, const Binding& binding,
                             const Lattice& lattice) const {
  if (!(binding.weight[0] > 0)) return true;
  const Vec3f& first = restOfCell_[std::size_t(binding.entry[0])];
  return (rest - first).norm() > 0.9f * float(lattice.spacing.minCoeff());
}

// What lies outside a particle with few bonds would follow each error of its gradient: it gets the
// mean gradient of the particle and of those that it is bonded to.
void SurfaceSkin::findMotions(const Lattice& lattice, const TissueModel& tissue) {
  const auto visitBonded = [&](std::size_t i, auto visit) {
    const Vec3i cell = lattice.cell(cells_[i]);
    for (int d = 0; d < kDirections; ++d)
      if (bondsOfCell_[i] >> d & 1) visit(lattice.index(cell + offsetOf(d)));
  };
  const auto followed = cells_.size();
  for (std::size_t i = bondsOfCell_.size(); i < followed; ++i)
    bondsOfCell_.push_back(tissue.bonds(cells_[i]));
  for (std::size_t i = 0; i < followed; ++i)
    if (isThin(bondsOfCell_[i])) visitBonded(i, [&](std::int64_t other) { entryOf(other); });
  for (std::size_t i = restOfCell_.size(); i < cells_.size(); ++i) {
    restOfCell_.push_back(lattice.centre(lattice.cell(cells_[i])).cast<float>());
    if (i >= followed) bondsOfCell_.push_back(tissue.bonds(cells_[i]));
  }
  placements_.resize(cells_.size());
  motions_.resize(
      std::max<std::size_t>(1, cells_.size()));  // vertices without particles use the first entry
  tissue.place(cells_, placements_);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Eigen::Matrix3f gradient = placements_[i].gradient;
    if (isThin(bondsOfCell_[i])) {
      visitBonded(i, [&](std::int64_t other) {
        gradient += placements_[std::size_t(entryOfCell_[std::size_t(other)])].gradient;
      });
      gradient /= float(1 + std::popcount(bondsOfCell_[i]));
    }
    motions_[i] = particleMotion(restOfCell_[i], placements_[i].displacement, gradient);
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

// Marks in due_ the vertices that must be bound anew; false if there is none. before: how many
// vertices were bound already.
bool SurfaceSkin::findDue(const SurfaceTracker& surface, std::size_t before, const Lattice& lattice,
                          const TissueModel& tissue, std::span<const std::int64_t> changedCells) {
  const SurfaceTracker::Changes& changes = surface.changes();
  const bool everything = changes.everything || before == 0;
  const bool particlesChanged = markChanged(changedCells, tissue);
  if (!everything && !particlesChanged && changedCells.empty() && changes.vertices.empty())
    return false;
  due_.assign(bindings_.size(), everything ? 1 : 0);
  if (everything) return true;
  // Only the bonds of the nearest particle matter, and all others of a binding are bonded to it.
  const auto isChanged = [&](const Binding& binding) {
    return binding.weight[0] > 0 && changed_[std::size_t(binding.entry[0])] != 0;
  };
  const bool cameBack =
      std::ranges::any_of(changedCells, [&](std::int64_t cell) { return tissue.solid(cell); });
  if (particlesChanged || cameBack)
    for (std::size_t v = 0; v < before; ++v)
      due_[v] = isChanged(bindings_[v]) ||
                (cameBack && followsFar(surface.points()[v], bindings_[v], lattice));
  for (const IndexRange& range : changes.vertices)
    std::fill_n(due_.begin() + range.first, range.count, std::uint8_t(1));
  return true;
}

void SurfaceSkin::follow(const SurfaceTracker& surface, const Lattice& lattice,
                         const TissueModel& tissue, std::span<const std::int64_t> changedCells,
                         bool withLook) {
  if (entryOfCell_.empty()) entryOfCell_.assign(lattice.cellCount(), -1);
  const std::span<const Vec3f> rest = surface.points();
  const std::size_t before = bindings_.size();
  bindings_.resize(rest.size());
  points_.resize(rest.size());

  if (findDue(surface, before, lattice, tissue, changedCells)) {
    // Beside a wound the tracker's bindings name the particles on a vertex's side.
    surface.visitBindings([&](std::int32_t first, std::span<const VertexBinding> bindings) {
      for (std::size_t i = 0; i < bindings.size(); ++i) {
        const std::size_t v = std::size_t(first) + i;
        if (bindings[i].count == 0) continue;
        setBinding(v, bindings[i], tissue);
        due_[v] = 0;
      }
    });
    for (std::size_t v = 0; v < due_.size(); ++v)
      if (due_[v]) setBinding(v, bindVertex(rest[v], lattice, tissue), tissue);
  }

  findMotions(lattice, tissue);
  movePoints(rest);
  if (withLook) turnNormals(surface);
}

std::size_t SurfaceSkin::bytes() const {
  return bindings_.capacity() * sizeof(Binding) + cells_.capacity() * sizeof(std::int64_t) +
         entryOfCell_.capacity() * sizeof(std::int32_t) +
         bondsOfCell_.capacity() * sizeof(std::uint32_t) +
         (restOfCell_.capacity() + points_.capacity() + normals_.capacity()) * sizeof(Vec3f) +
         placements_.capacity() * sizeof(CellPlacement) +
         motions_.capacity() * sizeof(ParticleMotion) + changed_.capacity() + due_.capacity();
}

}  // namespace resect

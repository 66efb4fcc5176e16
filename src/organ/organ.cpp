#include "organ/organ.h"

#include <cmath>

#include "base/error.h"

namespace resect {
namespace {

// visit(index of neighbour) for the up to 26 neighbours of `cell` in the lattice, in lattice order.
template <typename Visit>
void visitNeighbours(const Lattice& lattice, std::int64_t cell, Visit visit) {
  const Vec3i c = lattice.cell(cell);
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Vec3i n = c + Vec3i(dx, dy, dz);
        if ((dx || dy || dz) && lattice.contains(n))
          visit(lattice.index(n), dx * dx + dy * dy + dz * dz);
      }
}

}  // namespace

Organ makeOrgan(Discretization cells, const OrganSettings& settings) {
  if (settings.refine < 1 || settings.refine > 4)
    throw usageError("refine is {}; give 1, 2, 3 or 4 surface nodes per cell", settings.refine);
  requireIso(settings.iso);
  requireSound(cells);
  const std::int64_t particles = cells.particleCount();
  if (particles == 0)
    throw error(
        "the organ has no particle at a spacing of {:.3g} mm: no cell centre lies inside; use a "
        "smaller spacing",
        1e3 * cells.lattice.spacing.maxCoeff());
  const Vec3i dims = cells.lattice.dims;
  if (!ColourField::canHold(cells.lattice, settings.refine))
    throw error(
        "the organ's lattice of {} x {} x {} cells is too large for {} surface nodes per cell; use "
        "fewer, or a larger spacing",
        dims.x(), dims.y(), dims.z(), settings.refine);
  auto [field, surface] = buildFieldAndSurface(cells, settings.refine, settings.iso);
  std::vector<std::uint8_t> alive = cells.inside;
  for (std::size_t i = 0; i < alive.size(); ++i)
    if (!alive[i] && cells.value[i] > 0 && ownerCell(cells, std::int64_t(i)) == std::int64_t(i))
      alive[i] = 1;
  SeveredEdges severed(field.brickDims(), field.refine());
  CellFields fields{CellField<std::uint8_t>(cells.label), {}};
  HeatField heat(cells.lattice.box());
  return {std::move(cells),
          std::move(field),
          std::move(surface),
          std::move(severed),
          std::move(alive),
          {},
          {},
          particles,
          0,
          0,
          settings.iso,
          0,
          std::move(fields),
          nullptr,
          {},
          std::move(heat)};
}

std::int64_t ownerCell(const Discretization& rest, std::int64_t cell) {
  if (rest.inside[cell]) return cell;
  std::int64_t owner = cell;
  int nearest = 4;
  float fullest = -1;
  visitNeighbours(rest.lattice, cell, [&](std::int64_t n, int distance) {
    if (!rest.inside[n]) return;
    if (distance > nearest || (distance == nearest && rest.value[n] <= fullest)) return;
    owner = n;
    nearest = distance;
    fullest = rest.value[n];
  });
  return owner;
}

void visitCellsOf(const Discretization& rest, std::int64_t particle,
                  const std::function<void(std::int64_t)>& visit) {
  visit(particle);
  visitNeighbours(rest.lattice, particle, [&](std::int64_t n, int) {
    if (!rest.inside[n] && rest.value[n] > 0 && ownerCell(rest, n) == particle) visit(n);
  });
}

double particleVolume(const Discretization& rest, std::int64_t cell) {
  double sum = 0;
  visitCellsOf(rest, cell, [&](std::int64_t part) { sum += rest.cellVolume(part); });
  return sum;
}

void setParticle(Organ& organ, std::int64_t cell, bool there) {
  visitCellsOf(organ.rest, cell, [&](std::int64_t c) {
    organ.field.setCellValue(c, there ? organ.rest.value[std::size_t(c)] : 0);
  });
}

RemovedParticle removeParticle(Organ& organ, std::int64_t cell) {
  organ.alive[std::size_t(cell)] = 0;
  setParticle(organ, cell, false);
  const RemovedParticle gone{organ.rest.inside[std::size_t(cell)],
                             particleVolume(organ.rest, cell)};
  organ.particles -= gone.particles;
  organ.removed += gone.particles;
  organ.removedVolume += gone.volume;
  return gone;
}

std::span<const std::int64_t> updateField(Organ& organ) { return organ.field.update(organ.carved); }

std::int64_t incise(Organ& organ, const SweptBlade& blade, CutsBetweenCells cuts) {
  return severAtRest(organ.severed, organ.field, organ.iso, blade, cuts);
}

void updateSurface(Organ& organ, std::span<const std::int64_t> touchedBricks) {
  if (organ.severed.empty())
    organ.surface.update(organ.field, touchedBricks);
  else
    organ.surface.update(organ.field, touchedBricks, {organ.severed, organ.alive, organ.kerf},
                         organ.severed.update());
}

void updateRestoredSurface(Organ& organ, std::span<const std::int64_t> touchedBricks) {
  if (organ.iso != organ.surface.iso()) return setIso(organ, organ.iso);
  organ.severed.update();  // all bricks near a wound are meshed, whatever was severed
  const Wound wound{organ.severed, organ.alive, organ.kerf};
  organ.surface.updateRestored(organ.field, touchedBricks,
                               organ.severed.empty() ? nullptr : &wound);
}

void setIso(Organ& organ, float iso) {
  organ.severed.update();  // all bricks are meshed, whatever was severed
  const Wound wound{organ.severed, organ.alive, organ.kerf};
  organ.surface.setIso(organ.field, iso, organ.severed.empty() ? nullptr : &wound);
  organ.iso = iso;
}

}  // namespace resect

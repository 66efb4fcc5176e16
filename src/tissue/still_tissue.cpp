#include "tissue/still_tissue.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "tissue/stencil.h"

namespace resect {

StillTissue::StillTissue(const Lattice& lattice, std::vector<std::uint8_t> solid)
    : solid_(std::move(solid)), lattice_(lattice) {
  require(std::int64_t(solid_.size()) == lattice.cellCount(),
          "{} flags were given for {} cells; give one for each", solid_.size(),
          lattice.cellCount());
}

void StillTissue::endFrame(TissueStep& step) {
  step.substeps = step.retries = 0;
  step.calm = true;
  step.force.assign(obstacles_.size(), Vec3::Zero());
  step.torn.clear();
  step.letGo.clear();
  step.cuts.clear();
  for (const Obstacle& o : obstacles_)
    for (const CuttingEdge& edge : o.edges) {
      if (!edge.begins) continue;
      Aabb way;
      for (const Vec3& p : edge.points) way.grow(edge.from * p), way.grow(edge.to * p);
      if (!meets(way.padded(lattice_.spacing.maxCoeff()), lattice_.box()) || !movesToCut(edge))
        continue;
      std::vector<Vec3> points(edge.points.begin(), edge.points.end());
      if (edge.reversed) std::ranges::reverse(points);
      SweptBlade blade = sweepBlade(points, edge.from, edge.to);
      if (!blade.empty()) step.cuts.push_back({o.tool, std::move(blade)});
    }
  obstacles_ = {};
}

void StillTissue::remove(std::int64_t cell) {
  solid_[std::size_t(cell)] = 0;
  std::erase_if(held_, [&](const Held& held) { return held.cell == cell; });
}

std::uint32_t& StillTissue::severedAt(std::int64_t cell) {
  const auto at = std::ranges::lower_bound(severed_, cell, {}, &Severed::cell);
  if (at != severed_.end() && at->cell == cell) return at->directions;
  return severed_.insert(at, {cell, 0})->directions;
}

void StillTissue::sever(std::int64_t cell, int direction) {
  if (!(bonds(cell) >> direction & 1)) return;
  severedAt(cell) |= 1u << direction;
  severedAt(lattice_.index(lattice_.cell(cell) + offsetOf(direction))) |= 1u << opposite(direction);
}

void StillTissue::grip(std::int64_t cell, std::int32_t tool, const Pose&) {
  if (solid(cell) && std::ranges::find(held_, cell, &Held::cell) == held_.end())
    held_.push_back({cell, tool});
}

void StillTissue::release(std::int32_t tool) {
  std::erase_if(held_, [&](const Held& held) { return held.tool == tool; });
}

std::int32_t StillTissue::gripped(std::int32_t tool) const {
  return std::int32_t(std::ranges::count(held_, tool, &Held::tool));
}

std::uint32_t StillTissue::bonds(std::int64_t cell) const {
  if (!solid(cell)) return 0;
  const Vec3i at = lattice_.cell(cell);
  std::uint32_t bonds = 0;
  if ((at.array() > 0).all() && (at.array() < lattice_.dims.array() - 1).all()) {
    const std::int64_t y = lattice_.dims.x(), z = y * lattice_.dims.y();
    for (int d = 0; d < kDirections; ++d) {
      const std::int64_t other =
          cell + offsetAlong(d, 0) + y * offsetAlong(d, 1) + z * offsetAlong(d, 2);
      bonds |= std::uint32_t(solid_[std::size_t(other)] != 0) << d;
    }
  } else {
    for (int d = 0; d < kDirections; ++d) {
      const Vec3i other = at + offsetOf(d);
      if (lattice_.contains(other) && solid(lattice_.index(other))) bonds |= 1u << d;
    }
  }
  const auto gone = std::ranges::lower_bound(severed_, cell, {}, &Severed::cell);
  if (gone != severed_.end() && gone->cell == cell) bonds &= ~gone->directions;
  return bonds;
}

std::vector<std::int64_t> StillTissue::cellsIn(const Aabb& box) const {
  std::vector<std::int64_t> cells;
  visitCellsIn(lattice_, box, [&](const Vec3i& at) {
    const std::int64_t cell = lattice_.index(at);
    if (solid(cell)) cells.push_back(cell);
  });
  return cells;
}

void StillTissue::visit(StateVisitor& v) {
  v.perCell("solid", solid_, lattice_.order());
  v("severed", severed_), v("held", held_);
}

void StillTissue::visitMade(StateVisitor& v) { v.made(solid_, lattice_, obstacles_); }

void StillTissue::endRestore(std::span<const std::uint8_t> alive) {
  const auto inLattice = [&](std::int64_t cell) {
    return cell >= 0 && cell < lattice_.cellCount();
  };
  bool fits = std::int64_t(alive.size()) == lattice_.cellCount() &&
              std::ranges::is_sorted(severed_, {}, &Severed::cell);
  for (const Severed& s : severed_) fits = fits && inLattice(s.cell);
  for (const Held& h : held_) fits = fits && inLattice(h.cell);
  if (!fits)
    throw error(
        "the state does not fit the organ's tissue; restore it into the operation that it "
        "was saved from");
  solid_.assign(alive.begin(), alive.end());
}

}  // namespace resect

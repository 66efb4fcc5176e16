#include "organ/incision/node_owners.h"

#include <algorithm>
#include <bit>

#include "isosurface/brick_mesher.h"

namespace resect {

TissueGrid::TissueGrid(const Organ& organ, const IndexBox& nodes) : organ_(organ) {
  const Vec3i low = brickOf(nodes.low - Vec3i::Ones());
  const Vec3i high = brickOf(nodes.low + nodes.dims);
  box_ = {low, high - low + Vec3i::Constant(2)};  // and the bricks above, for edges that lead there
  bricks_.resize(box_.count());
}

unsigned TissueGrid::ways(const Vec3i& node) {
  const Brick& own = brick(brickOf(node));
  const int bit = bitOf(node);
  unsigned found = 0;
  for (int axis = 0; axis < 3; ++axis) {
    found |= unsigned(own.whole[axis] >> bit & 1) << (2 * axis + 1);
    const Vec3i below = node - Vec3i::Unit(axis);
    const Brick& lower = (node[axis] & 3) != 0 ? own : brick(brickOf(below));
    found |= unsigned(lower.whole[axis] >> bitOf(below) & 1) << (2 * axis);
  }
  return found;
}

bool TissueGrid::whole(const Vec3i& first, int side) {
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const Vec3i node = first + Vec3i(x, y, z);
        if (!(wholeCells(brickOf(node)) >> bitOf(node) & 1)) return false;
      }
  return true;
}

std::uint64_t TissueGrid::inside(const Vec3i& b) {
  Brick& made = bricks_[std::size_t(box_.index(b))];
  if (made.insideKnown) return made.inside;
  made.insideKnown = true;
  const ColourField& field = organ_.field;
  if ((b.array() >= 0).all() && (b.array() < field.brickDims().array()).all()) {
    const std::int32_t slot = field.slot(field.brickIndex(b));
    if (slot >= 0) made.inside = insideMask(field.values(slot), organ_.surface.iso());
    if (slot == ColourField::kFull) made.inside = ~std::uint64_t(0);
  }
  return made.inside;
}

const TissueGrid::Brick& TissueGrid::brick(const Vec3i& b) {
  Brick& made = bricks_[std::size_t(box_.index(b))];
  if (made.wholeKnown) return made;
  made.wholeKnown = true;
  if (inside(b) == 0) return made;
  std::array<std::uint64_t, 8> around{};  // the bricks above along one axis suffice
  around[0] = made.inside;
  for (int axis = 0; axis < 3; ++axis) around[1u << axis] = inside(b + Vec3i::Unit(axis));
  const auto corners = cornerMasks(around);
  for (int axis = 0; axis < 3; ++axis)
    made.whole[axis] =
        made.inside & corners[1u << axis] & ~organ_.severed.mask(organ_.field.brickIndex(b), axis);
  return made;
}

std::uint64_t TissueGrid::wholeCells(const Vec3i& b) {
  Brick& made = bricks_[std::size_t(box_.index(b))];
  if (made.cellsKnown) return made.cells;
  made.cellsKnown = true;
  made.cells = ~std::uint64_t(0);
  for (int axis = 0; axis < 3; ++axis) {
    std::array<std::uint64_t, 8> around{};  // of the cells' four edges along the axis
    const auto along = [&](unsigned corner) { return corner >> axis & 1; };
    for (unsigned c = 0; c < 8; ++c)
      if (!along(c)) around[c] = brick(b + Vec3i(c & 1, c >> 1 & 1, c >> 2)).whole[axis];
    const auto corners = cornerMasks(around);
    for (unsigned c = 0; c < 8; ++c)
      if (!along(c)) made.cells &= corners[c];
  }
  return made.cells;
}

NodeOwners::NodeOwners(const Organ& organ, TissueGrid& grid, const IndexBox& box)
    : organ_(organ), box_(box.widened(kFar)), grid_(grid), number_(box_.count(), kUnknown) {
  known_.reserve(box.count());
  for (int way = 0; way < 6; ++way) step_[way] = (way % 2 ? 1 : -1) * box_.step(way / 2);
}

std::int32_t NodeOwners::lookAt(std::int32_t i) {
  const Vec3i node = box_.coordinates(i);
  Known& made = known_.emplace_back();
  made.ways = std::uint8_t(grid_.ways(node));
  if (const std::int64_t p = particleAt(node); p >= 0) made.owner = std::int32_t(p);
  return std::int32_t(known_.size() - 1);
}

void NodeOwners::search(int edges, std::int32_t i) {
  Known own = known(i);
  while (own.owner == kNobody && own.searched < edges) {
    for (unsigned ways = own.ways; ways != 0; ways &= ways - 1)
      own.owner = std::min(own.owner, within(own.searched, i + step_[std::countr_zero(ways)]));
    ++own.searched;
  }
  known(i) = own;
}

std::int64_t NodeOwners::particleAt(const Vec3i& node) const {
  const int refine = organ_.field.refine();
  const Vec3i cell = node / refine - Vec3i::Constant(2);
  if ((node.array() != (refine * (cell.array() + 2))).any()) return -1;
  if (!organ_.rest.lattice.contains(cell)) return -1;
  const std::int64_t index = organ_.rest.lattice.index(cell);
  return organ_.alive[index] && organ_.rest.inside[index] ? index : -1;
}

}  // namespace resect

#include "blood/film/skin_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace resect {
namespace {

constexpr float kTurn = -0.3f;  // least cosine between the normals of cells that blood links
constexpr float kFull = 100;
constexpr int kReach = 2;  // cells round an edit whose skin it may change

// Weights of the 27 cells for means and gradients: 1, 1/2, 1/4, 1/8 by the number of steps.
float weightOf(int direction) { return 1.f / float(1 << neighbourKind(direction)); }

}  // namespace

SkinCells::SkinCells(const OperatedOrgan& organ)
    : lattice_(organ.organ.rest.lattice), numbers_{lattice_.dims} {
  for (int d = 0; d < kDirections; ++d) steps_[std::size_t(d)] = numbers_.step(d);
  cells_.resize(numbers_.count());
  const auto each = [&](auto visit) {
    for (std::int64_t c = 0; c < lattice_.cellCount(); ++c)
      if (organ.organ.alive[std::size_t(c)]) visit(lattice_.cell(c));
  };
  each([&](const Vec3i& cell) { find(organ, cell); });
  each([&](const Vec3i& cell) { link(cell); });
}

void SkinCells::renew(const OperatedOrgan& organ, std::span<const std::int64_t> cells,
                      std::vector<OpenedFaces>& opened) {
  std::vector<std::int64_t> near;
  for (const std::int64_t c : cells) {
    const Vec3i at = lattice_.cell(c);
    for (int z = -kReach; z <= kReach; ++z)
      for (int y = -kReach; y <= kReach; ++y)
        for (int x = -kReach; x <= kReach; ++x)
          if (const Vec3i n = at + Vec3i(x, y, z); lattice_.contains(n))
            near.push_back(lattice_.index(n));
  }
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const std::int64_t c : near) {
    const SkinCell& s = cells_[std::size_t(numberOf(c))];
    const std::uint32_t before = s.open;
    find(organ, lattice_.cell(c));
    if (const int faces = std::popcount(s.open & ~before)) opened.push_back({c, faces});
  }
  for (const std::int64_t c : near) link(lattice_.cell(c));
}

// Whether the cell has skin, and its normal, place and area.
void SkinCells::find(const OperatedOrgan& organ, const Vec3i& cell) {
  const std::int64_t index = lattice_.index(cell);
  SkinCell& s = cells_[std::size_t(numbers_.of(cell))];
  s = {};
  if (!organ.organ.alive[std::size_t(index)]) return;
  const std::uint32_t bonds = organ.tissue->bonds(index);
  Vec3f gradient = Vec3f::Zero();
  float mean = kFull, weights = 1;
  bool open = false;
  for (int d = 0; d < kDirections; ++d) {
    const Vec3i n = cell + offsetOf(d);
    float fill = 0;
    if (lattice_.contains(n)) {
      const std::int64_t i = lattice_.index(n);
      const bool alive = organ.organ.alive[std::size_t(i)];
      if (alive && (bonds >> d & 1))
        fill = kFull;
      else if (!alive && !organ.organ.rest.inside[std::size_t(i)])
        fill = organ.organ.field.cellValue(i);
      if (alive && !(bonds >> d & 1)) s.free |= 1u << d;
      if (neighbourKind(d) == 1 && !(alive && (bonds >> d & 1))) {
        s.open |= 1u << d;
        open |= !alive;
      }
    } else if (neighbourKind(d) == 1) {
      s.open |= 1u << d;
      open = true;
    }
    const float w = weightOf(d);
    gradient += w * fill * offsetOf(d).cast<float>();
    mean += w * fill;
    weights += w;
  }
  s.skin = s.open != 0;
  if (!s.skin) return;
  s.slit = !open;
  gradient /= 8;
  mean /= weights;
  const float steep = gradient.norm();
  const float side = float(lattice_.spacing.x());
  s.normal = steep > 1e-3f ? Vec3f(-gradient / steep) : Vec3f(Vec3f::UnitY());
  s.offset = s.normal * side * std::clamp((mean - 50) / std::max(20.f, steep), -0.2f, 0.9f);
  s.area = side * side / s.normal.cwiseAbs().maxCoeff();
}

void SkinCells::link(const Vec3i& cell) {
  const std::int32_t number = numbers_.of(cell);
  SkinCell& s = cells_[std::size_t(number)];
  s.ways = 0;
  if (!s.skin) return;
  for (int d = 0; d < kDirections; ++d) {
    if (s.free >> d & 1) continue;  // blood does not cross a closed lip
    const SkinCell& n = cells_[std::size_t(number + steps_[std::size_t(d)])];
    if (n.skin && s.normal.dot(n.normal) >= kTurn) s.ways |= 1u << d;
  }
}

}  // namespace resect

#include "tissue/elastic/cutting/rest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/swept_blade.h"
#include "tissue/elastic/boundary_cells.h"
#include "tissue/elastic/gradient.h"

namespace resect {
namespace {

constexpr double kLeastReach = 1.5;  // spacings: fewer cells would be crushed one by one
constexpr double kNearAhead = 0.5;   // of the way ahead

Aabb boxRound(const Vec3& point, double reach) { return Aabb{point, point}.padded(reach); }

}  // namespace

std::int32_t RestTissue::nearestSolid(const Vec3& point) const {
  double least = std::numeric_limits<double>::infinity();
  std::int32_t nearest = -1;
  visitCellsIn(lattice_, boxRound(point, 2 * state_.spacing), [&](const Vec3i& cell) {
    const std::int32_t i = state_.box.index(cell);
    const double distance2 = (lattice_.centre(cell) - point).squaredNorm();
    if (isParticle(state_, i) && distance2 < least) least = distance2, nearest = i;
  });
  return nearest;
}

void RestTissue::findCells(const Vec3& point, PointCells& found) const {
  const double reach = std::max(kCutReach, kLeastReach * state_.spacing);
  found.cells.clear(), found.weights.clear();
  found.mean.setZero();
  double sum = 0, least = std::numeric_limits<double>::infinity();
  found.nearest = -1;
  visitCellsIn(lattice_, boxRound(point, reach), [&](const Vec3i& cell) {
    const std::int32_t i = state_.box.index(cell);
    const Vec3 rest = lattice_.centre(cell);
    const double distance2 = (rest - point).squaredNorm() / (reach * reach);
    if (!isParticle(state_, i) || distance2 >= 1) return;
    const double weight = (1 - distance2) * (1 - distance2);
    found.cells.push_back(i), found.weights.push_back(weight);
    found.mean += weight * rest;
    sum += weight;
    if (distance2 < least) least = distance2, found.nearest = i;
  });
  constexpr double kLeastSum = 1e-3;
  if (sum < kLeastSum) {
    found.nearest = nearestSolid(point);
    found.cells.assign(found.nearest < 0 ? 0 : 1, found.nearest);
    found.weights.assign(found.cells.size(), 1);
    if (found.nearest < 0) return;
    found.mean = lattice_.centre(state_.box.cell(found.nearest));
  } else {
    for (double& weight : found.weights) weight /= sum;
    found.mean /= sum;
  }
  found.gradient = gradientAt(state_, found.nearest);
}

Vec3 RestTissue::displacement(const Vec3& point, const PointCells& near) const {
  Vec3 sum = Vec3::Zero();
  if (near.cells.size() == 1) sum = near.gradient * (point - near.mean);  // may be far outside
  for (std::size_t k = 0; k < near.cells.size(); ++k) {
    const std::int32_t i = near.cells[k];
    sum += near.weights[k] * Vec3(state_.u[0][i], state_.u[1][i], state_.u[2][i]);
  }
  return sum;
}

Vec3 RestTissue::velocity(const PointCells& near) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < near.cells.size(); ++k) {
    const std::int32_t i = near.cells[k];
    sum += near.weights[k] * Vec3(state_.v[0][i], state_.v[1][i], state_.v[2][i]);
  }
  return sum;
}

double RestTissue::apart(const Vec3& point, const PointCells& near) const {
  const std::int32_t i = near.nearest;
  const Vec3 own = Vec3(state_.u[0][i], state_.u[1][i], state_.u[2][i]) +
                   near.gradient * (point - lattice_.centre(state_.box.cell(i)));
  return (own - displacement(point, near)).norm();
}

double RestTissue::depth(const Vec3& point) const {
  const double s = state_.spacing;
  double least = std::numeric_limits<double>::infinity(), depth = 0;
  visitCellsIn(lattice_, boxRound(point, 1.5 * s), [&](const Vec3i& cell) {
    const std::int32_t i = state_.box.index(cell);
    if (!isParticle(state_, i)) return;
    const Vec3f from = (point - lattice_.centre(cell)).cast<float>();
    surface_.visitPatches(i, [&](const ContactPoint& patch) {
      const Vec3f off = from - patch.offset;
      if (const double distance2 = double(off.squaredNorm()); distance2 < least) {
        least = distance2;
        depth = -double(off.dot(patch.normal));
      }
    });
  });
  if (least < s * s) return depth;
  const Vec3 at = lattice_.toCellSpace(point);
  const Vec3i cell(int(std::lround(at.x())), int(std::lround(at.y())), int(std::lround(at.z())));
  const bool solid = lattice_.contains(cell) && isParticle(state_, state_.box.index(cell));
  return (solid ? kKnownDepth : -kKnownDepth) * s;
}

bool RestTissue::tissueAhead(const Vec3& point, const Vec3& along, const Vec3& ahead) const {
  const Vec3 half = 0.5 * state_.spacing * along;
  const Vec3 before[2] = {point - half, point + half};
  const Vec3 after[2] = {before[0] + ahead, before[1] + ahead};
  const SweptBlade strip = ruledBlade(before, after);
  bool bonded = false, close = false;  // the nearest pair; any pair that is near
  double least = std::numeric_limits<double>::infinity();
  visitCellsIn(lattice_, strip.bounds.padded(state_.spacing), [&](const Vec3i& cell) {
    const std::int32_t i = state_.box.index(cell);
    if (!isParticle(state_, i)) return;
    for (int d = kFirstForward; d < kDirections; ++d) {
      if (!isParticle(state_, i + state_.box.step[d])) continue;
      const Vec3 from = lattice_.centre(cell), to = lattice_.centre(cell + offsetOf(d));
      const auto met = crossing(strip, from, to);
      if (!met) continue;
      const double way = (from + met->share * (to - from) - point).dot(ahead);
      if (way < least) least = way, bonded = state_.bonds[i] >> d & 1;
      close |= (state_.bonds[i] >> d & 1) && way < kNearAhead * ahead.squaredNorm();
    }
  });
  return bonded || close;
}

}  // namespace resect

#include "operation/ledger/structure.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr std::size_t kLeaf = 8;  // points that are looked at one by one

// The cells with the label, and two more cells on each side.
IndexBox boxOf(const Discretization& rest, int label) {
  Vec3i low = rest.lattice.dims, high = -Vec3i::Ones();
  for (std::int64_t i = 0; i < rest.lattice.cellCount(); ++i)
    if (rest.inside[std::size_t(i)] && rest.labelOf(i) == label) {
      low = low.cwiseMin(rest.lattice.cell(i));
      high = high.cwiseMax(rest.lattice.cell(i));
    }
  return {low - Vec3i::Constant(2), high - low + Vec3i::Constant(5)};
}

// Weights 1, 2, 1 along an axis of the box.
void spread(const IndexBox& box, std::vector<std::uint8_t>& share, int axis) {
  const std::size_t step =
      axis == 0 ? 1 : std::size_t(box.dims.x()) * std::size_t(axis == 1 ? 1 : box.dims.y());
  const std::vector<std::uint8_t> before = share;
  for (std::size_t i = step; i + step < share.size(); ++i)
    share[i] = std::uint8_t(before[i - step] + 2 * before[i] + before[i + step]);
}

}  // namespace

Structure::Structure(const Discretization& rest, int label)
    : label_(label),
      origin_(rest.lattice.origin),
      spacing_(rest.lattice.spacing),
      box_(boxOf(rest, label)),
      share_(std::size_t(box_.count()), 0) {
  const auto labelled = [&](const Vec3i& cell) {
    if (!rest.lattice.contains(cell)) return false;
    const std::int64_t i = rest.lattice.index(cell);
    return rest.inside[std::size_t(i)] && rest.labelOf(i) == label;
  };
  // The outermost two layers of the box are empty, so nothing is spread round its ends.
  for (std::size_t i = 0; i < share_.size(); ++i)
    share_[i] = labelled(box_.coordinates(std::int32_t(i)));
  for (int axis = 0; axis < 3; ++axis) spread(box_, share_, axis);
  for (std::size_t i = 0; i < share_.size(); ++i)
    share_[i] = labelled(box_.coordinates(std::int32_t(i))) ? std::max<std::uint8_t>(share_[i], 33)
                                                            : std::min<std::uint8_t>(share_[i], 31);
  addPoints(rest.lattice);
  axis_.resize(points_.size());
  sortInto(0, points_.size());
}

void Structure::addPoints(const Lattice& lattice) {
  const std::size_t step[3] = {1, std::size_t(box_.dims.x()),
                               std::size_t(box_.dims.x()) * std::size_t(box_.dims.y())};
  low_ = Vec3f::Constant(1e30f), high_ = -low_;
  for (std::size_t i = 0; i + step[2] < share_.size(); ++i)
    for (int a = 0; a < 3; ++a) {
      const int here = share_[i], there = share_[i + step[a]];
      if ((here > 32) == (there > 32)) continue;
      Vec3 p = lattice.centre(box_.coordinates(std::int32_t(i)));
      p[a] += lattice.spacing[a] * double(here - 32) / double(here - there);
      points_.push_back(p.cast<float>());
      low_ = low_.cwiseMin(points_.back()), high_ = high_.cwiseMax(points_.back());
    }
}

// Sorts points so that those of a range lie on two sides of its middle one, and so on.
void Structure::sortInto(std::size_t begin, std::size_t end) {
  if (end - begin <= kLeaf) return;
  Vec3f low = points_[begin], high = low;
  for (std::size_t i = begin; i < end; ++i)
    low = low.cwiseMin(points_[i]), high = high.cwiseMax(points_[i]);
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return points_.begin() + std::ptrdiff_t(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [axis](const Vec3f& a, const Vec3f& b) { return a[axis] < b[axis]; });
  axis_[middle] = std::uint8_t(axis);
  sortInto(begin, middle);
  sortInto(middle + 1, end);
}

void Structure::search(std::size_t begin, std::size_t end, const Vec3f& point, float& best) const {
  if (end - begin <= kLeaf) {
    for (std::size_t i = begin; i < end; ++i)
      best = std::min(best, (points_[i] - point).squaredNorm());
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const int axis = axis_[middle];
  const float beside = point[axis] - points_[middle][axis];
  best = std::min(best, (points_[middle] - point).squaredNorm());
  const bool lower = beside < 0;
  lower ? search(begin, middle, point, best) : search(middle + 1, end, point, best);
  if (beside * beside < best)
    lower ? search(middle + 1, end, point, best) : search(begin, middle, point, best);
}

bool Structure::holds(const Vec3& point) const {
  const Vec3 at = (point - origin_).cwiseQuotient(spacing_) - box_.low.cast<double>();
  Vec3i low;
  for (int a = 0; a < 3; ++a) {
    low[a] = int(std::floor(at[a]));
    if (low[a] < 0 || low[a] + 1 >= box_.dims[a]) return false;
  }
  const Vec3 part = at - low.cast<double>();
  double share = 0;
  for (int c = 0; c < 8; ++c) {
    double weight = 1;
    Vec3i cell = box_.low + low;
    for (int a = 0; a < 3; ++a) {
      weight *= c >> a & 1 ? part[a] : 1 - part[a];
      cell[a] += c >> a & 1;
    }
    share += weight * share_[std::size_t(box_.index(cell))];
  }
  return share > 32;
}

double Structure::distance(const Vec3& point, double best) const {
  const Vec3f p = point.cast<float>();
  const float most = std::isinf(best) ? 1e30f : float(best * best);
  const float outside = (p - p.cwiseMax(low_).cwiseMin(high_)).squaredNorm();
  if (outside >= most) return best;
  if (outside == 0 && holds(point)) return 0;
  float found = most;
  search(0, points_.size(), p, found);
  return found < most ? std::sqrt(double(found)) : best;
}

}  // namespace resect

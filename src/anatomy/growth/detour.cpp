#include "anatomy/growth/detour.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>

namespace resect {
namespace {

constexpr double kStep = 0.0007;     // m: distance of places
constexpr double kAround = 0.01;     // m: beyond both ends
constexpr double kNearEnds = 0.004;  // m: a place with room is looked for so far from an end

// The places round both ends, and whether a vessel of a radius has room at them.
class LocalWays {
 public:
  LocalWays(const Vec3& from, const Vec3& to, double radius, const Surroundings& around)
      : radius_(radius), around_(around) {
    Aabb box;
    box.grow(from);
    box.grow(to);
    box = box.padded(kAround);
    lattice_.spacing = Vec3::Constant(kStep);
    lattice_.origin = box.min;
    for (int a = 0; a < 3; ++a) lattice_.dims[a] = int(box.size()[a] / kStep) + 1;
    free_.assign(std::size_t(lattice_.cellCount()), -1);
  }

  // Whether there is room from a to b.
  bool room(const Vec3& a, const Vec3& b) {
    if (!around_.inside.deep(a, b, radius_ + around_.depth)) return false;
    Aabb box;
    box.grow(a);
    box.grow(b);
    around_.index.near(box.padded(radius_ + around_.gap), near_);
    return std::ranges::all_of(near_, [&](std::int32_t j) {
      const VesselSegment& o = around_.others[std::size_t(j)];
      return segmentDistance(a, b, o.start, o.end) >= radius_ + o.radius + around_.gap;
    });
  }

  // The place with room nearest to p.
  std::optional<std::int64_t> nearest(const Vec3& p) {
    std::vector<std::pair<double, std::int64_t>> places;
    Aabb box;
    box.grow(p);
    visitCellsIn(lattice_, box.padded(kNearEnds), [&](const Vec3i& cell) {
      const double d = (lattice_.centre(cell) - p).squaredNorm();
      if (d <= kNearEnds * kNearEnds) places.emplace_back(d, lattice_.index(cell));
    });
    std::ranges::sort(places);
    for (const auto& [d, place] : places)
      if (free(place)) return place;
    return {};
  }

  // The shortest way over places with room (A*); empty if there is none.
  std::vector<Vec3> shortest(std::int64_t start, std::int64_t end) {
    const std::size_t count = free_.size();
    std::vector<double> least(count, std::numeric_limits<double>::infinity());
    std::vector<std::int64_t> before(count, -1);
    const Vec3 goal = at(end);
    using Entry = std::pair<double, std::int64_t>;  // length so far and the least that is left
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    least[std::size_t(start)] = 0;
    queue.emplace((at(start) - goal).norm(), start);
    while (!queue.empty()) {
      const auto [bound, place] = queue.top();
      queue.pop();
      if (place == end) break;
      const double here = least[std::size_t(place)];
      if (bound > here + (at(place) - goal).norm() + 1e-12) continue;
      for (int k = 0; k < 27; ++k) {
        const Vec3i step(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1), next = lattice_.cell(place) + step;
        if (!lattice_.contains(next)) continue;
        const std::int64_t n = lattice_.index(next);
        const double reached = here + kStep * step.cast<double>().norm();
        if (reached >= least[std::size_t(n)] || !free(n)) continue;
        least[std::size_t(n)] = reached;
        before[std::size_t(n)] = place;
        queue.emplace(reached + (at(n) - goal).norm(), n);
      }
    }
    std::vector<Vec3> way;
    if (least[std::size_t(end)] == std::numeric_limits<double>::infinity()) return way;
    for (std::int64_t i = end; i >= 0; i = before[std::size_t(i)]) way.push_back(at(i));
    std::ranges::reverse(way);
    return way;
  }

 private:
  Vec3 at(std::int64_t place) const { return lattice_.centre(lattice_.cell(place)); }
  bool free(std::int64_t place) {
    signed char& known = free_[std::size_t(place)];
    if (known < 0) known = room(at(place), at(place));
    return known > 0;
  }

  double radius_;
  const Surroundings& around_;
  Lattice lattice_;
  std::vector<signed char> free_;  // -1: not looked at yet
  std::vector<std::int32_t> near_;
};

}  // namespace

std::vector<Vec3> detour(const Vec3& from, const Vec3& to, double radius, double longest,
                         const Surroundings& around) {
  LocalWays ways(from, to, radius, around);
  const auto start = ways.nearest(from), end = ways.nearest(to);
  if (!start || !end) return {};
  std::vector<Vec3> way = ways.shortest(*start, *end);
  if (way.empty()) return {};
  way.insert(way.begin(), from);
  std::vector<Vec3> pulled{from};  // straight
  for (std::size_t i = 0; i + 1 < way.size();) {
    std::size_t j = way.size() - 1;
    while (j > i + 1 && ((way[j] - way[i]).norm() > longest || !ways.room(way[i], way[j]))) --j;
    pulled.push_back(way[j]);
    i = j;
  }
  return pulled;
}

}  // namespace resect

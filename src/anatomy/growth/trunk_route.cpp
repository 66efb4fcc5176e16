// Routes the first branches through the middle of the organ, round its corners.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "anatomy/growth/growing_vessels.h"

namespace resect {
namespace {

constexpr double kDeep = 0.008;  // m: a route nearer than this to the surface costs more
constexpr double kBeside = 30;   // added cost beside a vessel of another tree
constexpr double kLongestTrunkPiece = 0.03;  // m: of a piece
constexpr double kTrunkRoom = 0.0015;        // m: radius that a route keeps free below the surface

// The cheapest way over the places, from one to another.
// beside(p): whether p is too near to another vessel.
template <typename Beside>
std::vector<Vec3> cheapestWay(const OrganInside& inside, const Vec3& from, const Vec3& to,
                              Beside beside) {
  const Lattice& places = inside.places();
  const auto placeOf = [&](const Vec3& p) {
    const Vec3 q = places.toCellSpace(p);
    Vec3i at;
    for (int a = 0; a < 3; ++a)
      at[a] = std::clamp(int(std::floor(q[a] + 0.5)), 0, places.dims[a] - 1);
    return places.index(at);
  };
  const auto costAt = [&](std::int64_t place, const Vec3i& at) {
    const double shallow = kDeep / std::max(0.001, inside.depthAt(place));
    return 1 + shallow * shallow + (beside(places.centre(at)) ? kBeside : 0);
  };
  const std::size_t count = std::size_t(places.cellCount());
  std::vector<double> least(count, std::numeric_limits<double>::infinity()), cost(count, 0);
  std::vector<std::int64_t> before(count, -1);
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const std::int64_t start = placeOf(from), end = placeOf(to);
  least[std::size_t(start)] = 0;
  queue.emplace(0.0, start);
  while (!queue.empty()) {
    const auto [here, place] = queue.top();
    queue.pop();
    if (place == end) break;
    if (here > least[std::size_t(place)]) continue;
    const Vec3i at = places.cell(place);
    for (int k = 0; k < 27; ++k) {
      const Vec3i step(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1), next = at + step;
      if (!places.contains(next)) continue;
      const std::int64_t n = places.index(next);
      if (inside.depthAt(n) <= 0) continue;
      double& c = cost[std::size_t(n)];
      if (c == 0) c = costAt(n, next);
      const double reached = here + step.cast<double>().norm() * c;
      if (reached >= least[std::size_t(n)]) continue;
      least[std::size_t(n)] = reached;
      before[std::size_t(n)] = place;
      queue.emplace(reached, n);
    }
  }
  std::vector<Vec3> way;
  for (std::int64_t i = end; i >= 0; i = before[std::size_t(i)])
    way.push_back(places.centre(places.cell(i)));
  std::ranges::reverse(way);
  way.front() = from;
  way.back() = to;
  return way;
}

}  // namespace

std::vector<GrowingVessels::Obstacle> GrowingVessels::obstacles(int tree) const {
  const int kind = kindOf(tree);
  const double own =
      outer(0.75 * (kind ? settings_.trunkRadius : settings_.portalRadius), kind) + settings_.gap;
  std::vector<Obstacle> all;
  for (const GrowingNode& n : nodes_) {
    if (n.tree == tree || n.parent < 0) continue;
    const GrowingNode& start = nodes_[std::size_t(n.parent)];
    const int other = kindOf(n.tree);
    const double radius = other ? settings_.trunkRadius : settings_.portalRadius;
    all.push_back({start.place, n.place, own + outer(radius, other), start.parent < 0});
  }
  return all;
}

Vec3 GrowingVessels::openPlace(const Vec3& p, double depth, int tree) const {
  const std::vector<Obstacle> others = obstacles(tree);
  const Lattice& places = inside_.places();
  double least = std::numeric_limits<double>::infinity();
  Vec3 best = inside_.nearestPlace(p, depth);
  for (std::int64_t i = 0; i < places.cellCount(); ++i) {
    const Vec3 q = places.centre(places.cell(i));
    const double d = (q - p).squaredNorm();
    if (d >= least || inside_.depthAt(i) < depth) continue;
    if (std::ranges::any_of(others, [&](const Obstacle& o) {
          return segmentDistance(q, q, o.start, o.end) < o.keep;
        }))
      continue;
    least = d, best = q;
  }
  return best;
}

std::vector<Vec3> GrowingVessels::route(const Vec3& from, const Vec3& to, int tree) const {
  const std::vector<Obstacle> others = obstacles(tree);
  const std::vector<Vec3> way = cheapestWay(inside_, from, to, [&](const Vec3& p) {
    return std::ranges::any_of(
        others, [&](const Obstacle& o) { return segmentDistance(p, p, o.start, o.end) < o.keep; });
  });
  const auto open = [&](const Vec3& a, const Vec3& b) {
    return inside_.deep(a, b, kTrunkRoom + settings_.margin) &&
           std::ranges::all_of(others, [&](const Obstacle& o) {
             return o.stem || segmentDistance(a, b, o.start, o.end) >= o.keep;
           });
  };
  std::vector<Vec3> pulled{from};  // straight
  for (std::size_t i = 0; i + 1 < way.size();) {
    std::size_t j = way.size() - 1;
    while (j > i + 1 && ((way[j] - way[i]).norm() > kLongestTrunkPiece || !open(way[i], way[j])))
      --j;
    pulled.push_back(way[j]);
    i = j;
  }
  return pulled;
}

}  // namespace resect

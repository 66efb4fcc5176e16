#include "anatomy/growth/growing_vessels.h"

#include <algorithm>
#include <cmath>

#include "anatomy/growth/murray.h"

namespace resect {
namespace {

constexpr double kBin = 0.006;         // m
constexpr int kCandidates = 24;        // segments tried for a terminal
constexpr double kLeafSpare = 1.5;     // a leaf's room over its radius: others will branch from it
constexpr double kShortest = 0.0015;   // m: of a piece of vessel
constexpr double kThinnest = 0.00015;  // m: of a vessel that is narrowed

Aabb boxOf(const Vec3& a, const Vec3& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

// The point that joins a, b and c with the least volume: weighted Fermat point by Weiszfeld's
// iteration. w: cross-sections of the three vessels.
Vec3 fork(const Vec3& a, const Vec3& b, const Vec3& c, double wa, double wb, double wc) {
  Vec3 p = a + (b - a) * std::clamp((c - a).dot(b - a) / (b - a).squaredNorm(), 0.2, 0.8);
  p += 0.1 * (c - p);
  const auto pull = [&](double w, const Vec3& to) { return w / std::max(1e-6, (p - to).norm()); };
  for (int i = 0; i < 12; ++i) {
    const double pa = pull(wa, a), pb = pull(wb, b), pc = pull(wc, c);
    p = (pa * a + pb * b + pc * c) / (pa + pb + pc);
  }
  return p;
}

}  // namespace

GrowingVessels::GrowingVessels(const OrganInside& inside, const VesselGrowth& settings)
    : inside_(inside), settings_(settings) {
  widest_ = std::max(outer(settings.portalRadius, 0), settings.trunkRadius);
  leafRadius_ = {settings.portalRadius / murrayShare(settings.terminals),
                 settings.trunkRadius / murrayShare(double(settings.terminals) / kHepaticTrunks)};
  const Lattice& places = inside.places();
  binOrigin_ = places.box().min;
  for (int a = 0; a < 3; ++a) binDims_[a] = int(places.box().size()[a] / kBin) + 2;
  bins_.resize(std::size_t(binDims_.prod()));
}

double GrowingVessels::radius(int terminals, int kind) const {
  KnownRadii& known = knownRadii_[std::size_t(kind)];
  const int grown = std::max(1, terminals_[std::size_t(kind)]);
  if (known.grown != grown) known = {grown, std::vector<double>(std::size_t(grown) + 2, 0.0)};
  double& r = known.radius[std::size_t(terminals)];
  if (r == 0)
    r = leafRadius_[std::size_t(kind)] *
        murrayShare(terminals * (double(settings_.terminals) / grown));
  return r;
}

double GrowingVessels::radiusOf(const GrowingNode& node, int more) const {
  if (node.given > 0) return node.given;
  return std::min(node.most, radius(node.terminals + more, kindOf(node.tree)));
}

// The radius that is kept free round a segment.
double GrowingVessels::checkRadius(const GrowingNode& node) const {
  return node.leaf ? kLeafSpare * leafRadius(kindOf(node.tree)) : radiusOf(node);
}

template <typename Visit>
void GrowingVessels::visitBins(const Vec3& a, const Vec3& b, double reach, Visit visit) const {
  const Vec3 low = (a.cwiseMin(b) - Vec3::Constant(reach) - binOrigin_) / kBin,
             high = (a.cwiseMax(b) + Vec3::Constant(reach) - binOrigin_) / kBin;
  Vec3i first, last;
  for (int i = 0; i < 3; ++i) {
    first[i] = std::clamp(int(std::floor(low[i])), 0, binDims_[i] - 1);
    last[i] = std::clamp(int(std::floor(high[i])), 0, binDims_[i] - 1);
  }
  const Vec3 way = b - a;
  const double length2 = std::max(1e-18, way.squaredNorm());
  const double near = reach + 0.8661 * kBin;  // half the diagonal of a bin
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) {
        const Vec3 centre = binOrigin_ + kBin * Vec3(x + 0.5, y + 0.5, z + 0.5);
        const double t = std::clamp((centre - a).dot(way) / length2, 0.0, 1.0);
        if ((a + t * way - centre).squaredNorm() <= near * near &&
            !visit(std::size_t((z * binDims_.y() + y) * binDims_.x() + x)))
          return;
      }
}

void GrowingVessels::putIntoBins(int node) {
  const GrowingNode& n = nodes_[std::size_t(node)];
  if (n.parent < 0) return;
  visitBins(nodes_[std::size_t(n.parent)].place, n.place, 0, [&](std::size_t bin) {
    bins_[bin].push_back(node);
    return true;
  });
}

void GrowingVessels::takeFromBins(int node) {
  const GrowingNode& n = nodes_[std::size_t(node)];
  visitBins(nodes_[std::size_t(n.parent)].place, n.place, 0, [&](std::size_t bin) {
    std::erase(bins_[bin], node);
    return true;
  });
}

int GrowingVessels::add(const Vec3& place, int parent, int tree, int terminals, bool leaf) {
  nodes_.push_back({place, parent, terminals, tree, leaf});
  const int node = int(nodes_.size()) - 1;
  putIntoBins(node);
  return node;
}

void GrowingVessels::addGiven(std::span<const VesselSegment> vessels) {
  std::vector<int> node;  // by segment, at its end
  int tree = !vessels.empty() && vessels[0].kind == VesselKind::HepaticVein ? 1 : 0;
  for (const VesselSegment& s : vessels) {
    if (s.parent < 0 && !node.empty() && tree > 0) ++tree;
    const int from = s.parent < 0 ? addRoot(s.start, tree) : node[std::size_t(s.parent)];
    node.push_back(add(s.end, from, nodes_[std::size_t(from)].tree, 0, false));
    nodes_.back().given = s.radius;
    widest_ = std::max(widest_, outer(s.radius, kindOf(tree)));
  }
}

void GrowingVessels::addTrunk(int from, const Vec3& to) {
  const int tree = nodes_[std::size_t(from)].tree;
  const std::vector<Vec3> way = route(nodes_[std::size_t(from)].place, to, tree);
  for (int i = from; i >= 0; i = nodes_[std::size_t(i)].parent) ++nodes_[std::size_t(i)].terminals;
  int at = from;
  for (std::size_t i = 1; i < way.size(); ++i) at = add(way[i], at, tree, 1, i + 1 == way.size());
  ++terminals_[std::size_t(kindOf(tree))];
}

// Whether the segment meets the node, or is next to one that does.
bool GrowingVessels::kin(int segment, int node) const {
  const int start = nodes_[std::size_t(segment)].parent, up = nodes_[std::size_t(node)].parent;
  return segment == node || start == node || start == up || segment == up ||
         nodes_[std::size_t(start)].parent == node ||
         (up >= 0 && nodes_[std::size_t(up)].parent == segment);
}

bool GrowingVessels::clearOfOthers(const Vec3& a, const Vec3& b, double outerRadius,
                                   int tree) const {
  const Aabb box = boxOf(a, b);
  bool clear = true;
  visitBins(a, b, outerRadius + 1.2 * widest_ + settings_.gap, [&](std::size_t bin) {
    for (const int i : bins_[bin]) {
      const GrowingNode& other = nodes_[std::size_t(i)];
      if (other.tree == tree) continue;
      const Vec3& start = nodes_[std::size_t(other.parent)].place;
      const double keep =
          outerRadius + outer(checkRadius(other), kindOf(other.tree)) + settings_.gap;
      if (!meets(box.padded(keep), boxOf(start, other.place))) continue;
      if (segmentDistance(a, b, start, other.place) < keep) return clear = false;
    }
    return true;
  });
  return clear;
}

// Against the segment's own tree, leaving out segments that are kin to the nodes `first` and
// `second` (-1: none).
bool GrowingVessels::clearOfOwn(const Vec3& a, const Vec3& b, double radius, int tree, int first,
                                int second) const {
  bool clear = true;
  visitBins(a, b, radius + 1.2 * widest_, [&](std::size_t bin) {
    for (const int i : bins_[bin]) {
      const GrowingNode& other = nodes_[std::size_t(i)];
      if (other.tree != tree || kin(i, first) || (second >= 0 && kin(i, second))) continue;
      if (segmentDistance(a, b, nodes_[std::size_t(other.parent)].place, other.place) <
          radius + checkRadius(other))
        return clear = false;
    }
    return true;
  });
  return clear;
}

std::vector<GrowingVessels::Join> GrowingVessels::joins(const Vec3& place, int kind) const {
  std::vector<std::pair<double, int>> near;
  for (int i = 0; i < int(nodes_.size()); ++i) {
    const GrowingNode& n = nodes_[std::size_t(i)];
    if (n.parent < 0 || kindOf(n.tree) != kind) continue;
    const Vec3 &a = nodes_[std::size_t(n.parent)].place, way = n.place - a;
    const double t = std::clamp((place - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
    near.emplace_back((a + t * way - place).squaredNorm(), i);
  }
  const std::size_t count = std::min<std::size_t>(kCandidates, near.size());
  std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
  near.resize(count);

  std::vector<Join> found;
  const double leaf = kLeafSpare * leafRadius(kind), leafArea = leaf * leaf;
  for (const auto& [distance, i] : near) {
    const GrowingNode& n = nodes_[std::size_t(i)];
    const Vec3& start = nodes_[std::size_t(n.parent)].place;
    const double r1 = radiusOf(n), r0 = radiusOf(n, 1);
    if (n.given > 0) {
      if ((n.place - place).norm() > std::max(1.5 * r1, 0.002))
        found.push_back({leafArea * (n.place - place).norm(), i, n.place});
      continue;
    }
    Vec3 p = fork(start, n.place, place, r0 * r0, r1 * r1, leafArea);
    const double shortest = std::max(kShortest, 1.2 * r0);  // forks keep apart
    if ((p - start).norm() < shortest) p = start + (p - start).normalized() * shortest;
    if ((p - n.place).norm() < shortest) p = n.place + (p - n.place).normalized() * shortest;
    if ((p - start).norm() < 0.9 * shortest || (p - place).norm() < std::max(1.5 * r1, 0.002))
      continue;
    double cost = r0 * r0 * (p - start).norm() + r1 * r1 * (p - n.place).norm() +
                  leafArea * (p - place).norm() - r1 * r1 * (n.place - start).norm();
    for (int j = n.parent; nodes_[std::size_t(j)].parent >= 0; j = nodes_[std::size_t(j)].parent) {
      const GrowingNode& up = nodes_[std::size_t(j)];
      const double q0 = radiusOf(up), q1 = radiusOf(up, 1);
      cost += (q1 * q1 - q0 * q0) * (up.place - nodes_[std::size_t(up.parent)].place).norm();
    }
    found.push_back({cost, i, p});
  }
  std::sort(found.begin(), found.end(), [](const Join& a, const Join& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.node < b.node);
  });
  return found;
}

// Of a segment there is nothing to test but the new vessel: what was given stays.
bool GrowingVessels::fitsOnGiven(const GrowingNode& from, int node, const Vec3& place,
                                 int kind) const {
  const double leaf = kLeafSpare * leafRadius(kind), length = (place - from.place).norm();
  const auto after = [&](double way) {
    return Vec3(from.place + (place - from.place) * std::min(0.9, way / length));
  };
  return inside_.deep(after(from.given), place, outer(leaf, kind) + settings_.margin) &&
         clearOfOthers(after(from.given), place, outer(leaf, kind), from.tree) &&
         clearOfOwn(after(2 * from.given), place, leaf, from.tree, node, -1);
}

bool GrowingVessels::fits(const Join& join, const Vec3& place, int kind) const {
  const GrowingNode& n = nodes_[std::size_t(join.node)];
  if (n.given > 0) return fitsOnGiven(n, join.node, place, kind);
  const Vec3 start = nodes_[std::size_t(n.parent)].place, end = n.place;
  const bool stem = nodes_[std::size_t(n.parent)].parent < 0;  // it comes from outside
  const double r0 = radiusOf(n, 1), r1 = checkRadius(n), leaf = kLeafSpare * leafRadius(kind);
  const double o0 = outer(r0, kind), o1 = outer(r1, kind), ol = outer(leaf, kind);
  const auto least = [&](double wanted, const Vec3& end) {
    return std::min(wanted + settings_.margin, 0.9 * inside_.depth(end));
  };
  if (!inside_.deep(join.fork, place, ol + settings_.margin)) return false;
  if (!inside_.deep(join.fork, end, least(o1, end))) return false;
  if (!stem && !inside_.deep(start, join.fork, least(o0, start))) return false;

  // The own tree is tested away from forks, where vessels of one tree join.
  const auto trimmed = [](const Vec3& a, const Vec3& b, double cut) {
    return a + (b - a) * std::min(0.9, cut / (b - a).norm());
  };
  const auto short0 = [&](const Vec3& a, const Vec3& b) {
    return std::min(0.45 * (b - a).norm(), 2 * r0);
  };
  if (!clearOfOthers(join.fork, place, ol, n.tree)) return false;
  if (!clearOfOwn(trimmed(join.fork, place, 2 * r0), place, leaf, n.tree, join.node, -1))
    return false;
  if (!clearOfOthers(start, join.fork, o0, n.tree)) return false;
  if (!clearOfOwn(trimmed(start, join.fork, short0(start, join.fork)),
                  trimmed(join.fork, start, short0(start, join.fork)), 0.8 * r0, n.tree, n.parent,
                  join.node))
    return false;
  if (!clearOfOthers(join.fork, end, o1, n.tree)) return false;
  return clearOfOwn(trimmed(join.fork, end, short0(join.fork, end)),
                    trimmed(end, join.fork, short0(join.fork, end)), 0.8 * r1, n.tree, join.node,
                    n.parent);
}

void GrowingVessels::apply(const Join& join, const Vec3& place) {
  const int i = join.node, tree = nodes_[std::size_t(i)].tree;
  const GrowingNode n = nodes_[std::size_t(i)];
  int middle = i;
  if (n.given == 0) {
    takeFromBins(i);
    middle = int(nodes_.size());
    nodes_.push_back({join.fork, n.parent, n.terminals, tree, false, 0, n.most});
    nodes_[std::size_t(i)].parent = middle;
    putIntoBins(middle);
    putIntoBins(i);
  }
  add(place, middle, tree, 1, true);
  nodes_.back().most = n.given > 0 ? n.given : n.most;
  for (int j = middle; j >= 0; j = nodes_[std::size_t(j)].parent)
    ++nodes_[std::size_t(j)].terminals;
  ++terminals_[std::size_t(kindOf(tree))];
}

bool GrowingVessels::grow(const Vec3& place, int kind) {
  for (const Join& join : joins(place, kind))
    if (fits(join, place, kind)) {
      apply(join, place);
      return true;
    }
  return false;
}

std::vector<double> GrowingVessels::finalRadii() const {
  std::vector<double> r(nodes_.size(), 0);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const GrowingNode& n = nodes_[i];
    if (n.parent < 0) continue;
    r[i] = radiusOf(n);
    if (n.given > 0) continue;
    const GrowingNode& from = nodes_[std::size_t(n.parent)];
    if (from.parent < 0) continue;
    const int steps = 1 + int((n.place - from.place).norm() / 0.001);
    for (int k = 0; k <= steps; ++k) {
      const double depth = inside_.depth(from.place + (n.place - from.place) * (double(k) / steps));
      const double spare = n.tree == 0 ? settings_.sheath : 1;
      r[i] = std::min(r[i], std::max(kThinnest, (depth - 0.2e-3) / spare));
    }
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const GrowingNode& n = nodes_[i];
    if (n.parent < 0) continue;
    const Vec3& a = nodes_[std::size_t(n.parent)].place;
    visitBins(a, n.place, outer(r[i], kindOf(n.tree)) + widest_, [&](std::size_t bin) {
      for (const int j : bins_[bin]) {
        const GrowingNode& other = nodes_[std::size_t(j)];
        if (j <= int(i) || kindOf(other.tree) == kindOf(n.tree)) continue;
        const double d =
            segmentDistance(a, n.place, nodes_[std::size_t(other.parent)].place, other.place);
        const double room = d - 0.25 * settings_.gap;
        const double own = outer(r[i], kindOf(n.tree)),
                     others = outer(r[std::size_t(j)], kindOf(other.tree));
        if (own + others <= room) continue;
        // What was given keeps its radius.
        const double fixed = (n.given > 0 ? own : 0) + (other.given > 0 ? others : 0);
        const double share = std::max(0.1, (room - fixed) / (own + others - fixed));
        if (n.given == 0) r[i] *= share;
        if (other.given == 0) r[std::size_t(j)] *= share;
      }
      return true;
    });
  }
  return r;
}

}  // namespace resect

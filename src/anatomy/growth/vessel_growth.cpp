#include "anatomy/growth/vessel_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "anatomy/growth/growing_vessels.h"
#include "anatomy/growth/triads.h"
#include "base/error.h"
#include "base/random.h"

namespace resect {
namespace {

constexpr int kChoose = 8;         // random places per terminal, of which the best is taken
constexpr int kTriesPerLeaf = 40;  // places tried per terminal before growth ends
constexpr int kPlacesPerCell = 2;
constexpr double kOtherKind = 3;  // weight of the other kind's terminals: squared distances
constexpr double kTerritoryDepth = 0.005;  // m: of the middle of a first branch's territory

// Random places where a terminal has room.
std::vector<Vec3> openPlaces(const OrganInside& inside, double depth, Random& random) {
  std::vector<Vec3> open;
  const Lattice& places = inside.places();
  for (std::int64_t i = 0; i < places.cellCount(); ++i)
    for (int k = 0; k < kPlacesPerCell; ++k) {
      Vec3 shift;
      for (int a = 0; a < 3; ++a) shift[a] = random.uniform(-0.5, 0.5);
      const Vec3 p = places.centre(places.cell(i)) + places.spacing.cwiseProduct(shift);
      if (inside.depth(p) > depth) open.push_back(p);
    }
  return open;
}

// Middles of `count` territories of about equal size: k-means of the places.
std::vector<Vec3> territories(const OrganInside& inside, const std::vector<Vec3>& places, int count,
                              const Vec3& from) {
  std::vector<Vec3> middles{places[0]};
  while (int(middles.size()) < count) {  // start far from each other and from the root
    Vec3 best = places[0];
    double farthest = -1;
    for (const Vec3& p : places) {
      double d = (p - from).norm();
      for (const Vec3& m : middles) d = std::min(d, (p - m).norm());
      if (d > farthest) farthest = d, best = p;
    }
    middles.push_back(best);
  }
  for (int round = 0; round < 12; ++round) {
    std::vector<Vec3> sum(std::size_t(count), Vec3::Zero());
    std::vector<int> number(std::size_t(count), 0);
    for (const Vec3& p : places) {
      std::size_t nearest = 0;
      for (std::size_t m = 1; m < middles.size(); ++m)
        if ((p - middles[m]).squaredNorm() < (p - middles[nearest]).squaredNorm()) nearest = m;
      sum[nearest] += p;
      ++number[nearest];
    }
    for (std::size_t m = 0; m < middles.size(); ++m) middles[m] = sum[m] / std::max(1, number[m]);
  }
  for (Vec3& m : middles) m = inside.nearestPlace(m, kTerritoryDepth);
  return middles;
}

void addPortalStem(GrowingVessels& vessels, const OrganInside& inside,
                   const std::vector<Vec3>& places, const VesselGrowth& g) {
  const int root = vessels.addRoot(g.hilumOut, 0);
  const int stem =
      vessels.addStem(inside.nearestPlace(g.hilum, 0.8 * vessels.outer(g.portalRadius, 0)), root);
  for (const Vec3& middle : territories(inside, places, kHepaticTrunks, g.hilum))
    vessels.addTrunk(stem, middle);
}

// Three trunks, with their mouths apart from each other along the groove of the vena cava.
void addHepaticStems(GrowingVessels& vessels, const OrganInside& inside,
                     const std::vector<Vec3>& places, const VesselGrowth& g) {
  std::vector<Vec3> middles = territories(inside, places, kHepaticTrunks, g.cava);
  for (Vec3& m : middles) m = vessels.openPlace(m, kTerritoryDepth, 1);
  std::vector<Vec3> mouths;
  const Lattice& lattice = inside.places();
  for (int trunk = 0; trunk < kHepaticTrunks; ++trunk) {
    Vec3 mouth = inside.nearestPlace(g.cava, g.trunkRadius + g.margin);
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t i = 0; i < lattice.cellCount(); ++i) {
      if (inside.depthAt(i) < g.trunkRadius + g.margin) continue;
      const Vec3 p = lattice.centre(lattice.cell(i));
      const bool apart = std::ranges::all_of(mouths, [&](const Vec3& other) {
        return (other - p).norm() > 2 * g.trunkRadius + 0.002;
      });
      const double cost = (p - g.cava).norm() + 0.3 * (p - middles[std::size_t(trunk)]).norm();
      if (apart && cost < least) least = cost, mouth = p;
    }
    mouths.push_back(mouth);
    const int root = vessels.addRoot(g.cavaOut, trunk + 1);
    vessels.addTrunk(vessels.addStem(mouth, root), middles[std::size_t(trunk)]);
  }
}

// The kind with fewer terminals goes next: one that ran ahead would lock the other out.
void addTerminals(GrowingVessels& vessels, const std::vector<Vec3>& places, int terminals,
                  Random& random) {
  std::vector<float> distance2[2];  // to the terminals of the kind
  for (auto& d : distance2) d.assign(places.size(), std::numeric_limits<float>::max());
  const auto took = [&](const Vec3& p, int kind) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double d = (places[i] - p).squaredNorm();
      for (int k = 0; k < 2; ++k)
        distance2[k][i] = std::min(distance2[k][i], float(d * (k == kind ? 1 : kOtherKind)));
    }
  };
  for (const GrowingNode& n : vessels.nodes())
    if (n.leaf) took(n.place, GrowingVessels::kindOf(n.tree));
  for (int turn = 0; turn < kTriesPerLeaf * terminals; ++turn) {
    const int kind = vessels.terminals(0) <= vessels.terminals(1) ? 0 : 1;
    if (vessels.terminals(kind) >= terminals) return;
    std::size_t best = 0;
    float farthest = -1;
    for (int k = 0; k < kChoose; ++k) {
      const std::size_t i = std::size_t(random.below(int(places.size())));
      if (distance2[kind][i] > farthest) farthest = distance2[kind][i], best = i;
    }
    if (vessels.grow(places[best], kind)) took(places[best], kind);
  }
}

// Segments of the nodes, parents first, the portal vein before the hepatic veins. Both keep the
// order in which a search from the root finds them.
std::vector<VesselSegment> segmentsOf(const GrowingVessels& vessels) {
  const std::vector<GrowingNode>& nodes = vessels.nodes();
  const std::vector<double> radii = vessels.finalRadii();
  std::vector<std::vector<int>> children(nodes.size());
  std::vector<VesselSegment> segments;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].parent >= 0) children[std::size_t(nodes[i].parent)].push_back(int(i));
  for (const int kind : {0, 1})
    for (std::size_t root = 0; root < nodes.size(); ++root) {
      if (nodes[root].parent >= 0 || GrowingVessels::kindOf(nodes[root].tree) != kind) continue;
      std::vector<std::pair<int, std::int32_t>> open;  // node, segment that leads to its parent
      for (const int child : children[root]) open.emplace_back(child, -1);
      while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        const GrowingNode& n = nodes[std::size_t(node)];
        const std::int32_t number = std::int32_t(segments.size());
        segments.push_back({kind ? VesselKind::HepaticVein : VesselKind::PortalVein, parent,
                            nodes[std::size_t(n.parent)].place, n.place, radii[std::size_t(node)],
                            children[std::size_t(node)].empty()});
        for (const int child : children[std::size_t(node)]) open.emplace_back(child, number);
      }
    }
  return segments;
}

// Those of a kind, with parents that count from the first of them.
std::vector<VesselSegment> ofKind(std::span<const VesselSegment> all, VesselKind kind) {
  std::vector<std::int32_t> number(all.size(), -1);
  std::vector<VesselSegment> own;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].kind != kind) continue;
    number[i] = std::int32_t(own.size());
    own.push_back(all[i]);
    if (all[i].parent >= 0) own.back().parent = number[std::size_t(all[i].parent)];
  }
  return own;
}

double widestOf(std::span<const VesselSegment> vessels) {
  double widest = 0;
  for (const VesselSegment& s : vessels) widest = std::max(widest, s.radius);
  return widest;
}

}  // namespace

Anatomy growVessels(const TriangleMesh& surface, const VesselGrowth& wanted,
                    std::span<const VesselSegment> given) {
  require(wanted.terminals >= 30 && wanted.terminals <= 5000,
          "vessels of {} terminals were asked for; give 30 to 5000", wanted.terminals);
  for (const Vec3* place : {&wanted.hilum, &wanted.hilumOut, &wanted.cava, &wanted.cavaOut})
    require(place->allFinite(), "the place of hilum or vena cava is not a number; give metres");
  const auto portal = ofKind(given, VesselKind::PortalVein),
             hepatic = ofKind(given, VesselKind::HepaticVein);
  VesselGrowth settings = wanted;
  if (!portal.empty()) settings.portalRadius = std::min(wanted.portalRadius, widestOf(portal));
  if (!hepatic.empty()) settings.trunkRadius = std::min(wanted.trunkRadius, widestOf(hepatic));
  const OrganInside inside(surface);
  GrowingVessels vessels(inside, settings);
  Random random(settings.seed);
  const double room =
      settings.margin + 0.0003 +
      1.5 * std::max(vessels.outer(vessels.leafRadius(0), 0), vessels.leafRadius(1));
  const std::vector<Vec3> places = openPlaces(inside, room, random);
  require(int(places.size()) >= settings.terminals,
          "this organ has room for {} of {} terminals; ask for fewer", places.size(),
          settings.terminals);
  vessels.addGiven(portal);
  vessels.addGiven(hepatic);
  if (portal.empty()) addPortalStem(vessels, inside, places, settings);
  if (hepatic.empty()) addHepaticStems(vessels, inside, places, settings);
  addTerminals(vessels, places, settings.terminals, random);
  std::vector<VesselSegment> segments = segmentsOf(vessels);
  for (const VesselKind kind : {VesselKind::HepaticArtery, VesselKind::BileDuct}) {
    const auto first = std::int32_t(segments.size());
    for (VesselSegment s : ofKind(given, kind)) {
      if (s.parent >= 0) s.parent += first;
      segments.push_back(s);
    }
  }
  addTriads(segments, settings, inside);
  return makeAnatomy(std::move(segments));
}

}  // namespace resect

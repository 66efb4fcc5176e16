#include "blood/flow/vessel_flow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace resect {
namespace {

constexpr double kJetLoss = 1.56;   // of a jet from a sharp end
constexpr double kBackwards = 0.2;  // what a leaf carries out of collapsing sinusoids
constexpr int kRounds = 4;
// m/s: a jet is not linear about a slower flow, since its tangent would have no resistance; and no
// pressure of the body drives blood out of an end faster.
constexpr double kLeastSpeed = 1e-4, kFastest = 5;
constexpr double kHeldOpen = 1.5e-3;  // m: radius from which hepatic veins stay open
// m^3/s per Pa: holds the pressure of a part of the tissue where it was, if nothing else does.
// Vessels conduct a billion times as much.
constexpr double kStays = 1e-19;
constexpr VesselKind kBlood[] = {VesselKind::PortalVein, VesselKind::HepaticVein,
                                 VesselKind::HepaticArtery};

double poiseuille(const VesselSegment& s) {
  const double r2 = s.radius * s.radius;
  return 8 * kBloodViscosity * s.length() / (std::numbers::pi * r2 * r2);
}

// Of a jet: pressure per square of its flow.
double lossOf(double area) { return kJetLoss * kBloodDensity / (2 * area * area); }

// An open end, linear about its last flow: flow out of it = g (p - pressure).
struct OpenEnd {
  double g = 0, pressure = 0;
};

// The same conductance behind a resistance.
double behind(double resistance, double conductance) {
  return conductance / (1 + resistance * conductance);
}

}  // namespace

VesselFlow::VesselFlow(std::shared_ptr<const VesselMap> map, const Circulation& circulation)
    : map_(std::move(map)), anatomy_(&map_->anatomy) {
  const Anatomy& anatomy = *anatomy_;
  for (const VesselKind kind : kBlood) {
    Tree& tree = trees_[std::size_t(kind)];
    tree.range = anatomy.range(kind);
    tree.supply = kind == VesselKind::PortalVein    ? circulation.portal
                  : kind == VesselKind::HepaticVein ? circulation.hepatic
                                                    : circulation.artery;
    const std::size_t count = std::size_t(tree.range.count);
    tree.resistance.resize(count);
    tree.firstChild.assign(count + 1, 0);
    const auto segment = [&](std::size_t i) -> const VesselSegment& {
      return anatomy.segments[std::size_t(tree.range.first) + i];
    };
    const auto parentOf = [&](std::size_t i) {
      const std::int32_t parent = segment(i).parent;
      return parent < 0 ? -1 : parent - tree.range.first;
    };
    for (std::size_t i = 0; i < count; ++i) {
      tree.resistance[i] = poiseuille(segment(i));
      if (parentOf(i) < 0)
        tree.roots.push_back(std::int32_t(i));
      else
        ++tree.firstChild[std::size_t(parentOf(i)) + 1];
    }
    for (std::size_t i = 0; i < count; ++i) tree.firstChild[i + 1] += tree.firstChild[i];
    tree.children.resize(std::size_t(tree.firstChild.back()));
    std::vector<std::int32_t> next(tree.firstChild.begin(), tree.firstChild.end());
    for (std::size_t i = 0; i < count; ++i)
      if (parentOf(i) >= 0)
        tree.children[std::size_t(next[std::size_t(parentOf(i))]++)] = std::int32_t(i);

    // The leaves' conductance is such that the healthy organ has the flow of its supply.
    const double root = tree.supply.pressure - tree.supply.resistance * tree.supply.flow;
    const double wanted = tree.supply.flow / (root - circulation.sinusoids);
    double low = 1e-16, high = 1e-6;
    for (int i = 0; i < 100 && count > 0; ++i) {
      const double middle = std::sqrt(low * high);
      (conductance(tree, middle) < wanted ? low : high) = middle;
    }
    tree.leafConductance = low;
    condense(tree);
  }
}

// Of the tree from its root to the sinusoids, if each leaf has the conductance `leaf`.
double VesselFlow::conductance(Tree& tree, double leaf) const {
  tree.leafConductance = leaf;
  condense(tree);
  double sum = 0;
  for (const std::int32_t root : tree.roots) sum += tree.seen[0][std::size_t(root)];
  return sum;
}

void VesselFlow::condense(Tree& tree) const {
  const bool collapses = tree.supply.flow > 0;
  for (int backwards = 0; backwards < 2; ++backwards) {
    const double leaf = tree.leafConductance * (backwards && collapses ? kBackwards : 1);
    std::vector<double>& seen = tree.seen[std::size_t(backwards)];
    seen.assign(tree.resistance.size(), 0);
    for (std::size_t i = seen.size(); i-- > 0;) {
      double sum = anatomy_->segments[std::size_t(tree.range.first) + i].leaf ? leaf : 0;
      for (std::int32_t c = tree.firstChild[i]; c < tree.firstChild[i + 1]; ++c)
        sum += seen[std::size_t(tree.children[std::size_t(c)])];
      seen[i] = behind(tree.resistance[i], sum);
    }
  }
}

// The part of a tree that injuries concern: their segments, those with clips, those from which
// branches lead into different parts of the tissue, and those between them and the root.
struct VesselFlow::Part {
  struct Node {
    std::int32_t segment;      // within the tree
    std::int32_t parent = -1;  // index of its node; -1: the root
    std::int32_t injury = -1;  // index in VesselState::injuries
    bool shut = false;         // by a clip, without being severed
    bool cutOff = false;       // what is beyond it is, from the root
    double g = 0, j = 0;       // at its end: flow into what is beyond = g p - j
    double pressure = 0;       // at its end
  };
  // All that leads from the end of a node into the sinusoids of one part of the tissue, past other
  // nodes.
  struct Feed {
    std::int32_t node;   // index; -1: the root
    std::int32_t place;  // part of the tissue
    double conductance;
  };
  std::vector<Node> nodes;  // ascending by segment
  std::vector<Feed> feeds;
};

// fed: by part of the tissue, set for those that vessels join to the root.
VesselFlow::Part VesselFlow::concernedPart(const Tree& tree, const VesselState& state,
                                           std::vector<bool>& fed) const {
  const std::int32_t first = tree.range.first;
  const auto mine = [&](std::int32_t segment) {
    return segment >= first && segment < first + tree.range.count;
  };
  std::vector<std::int32_t> place(tree.resistance.size(), 0);  // index by segment
  for (const SegmentPart& apart : state.apart)
    if (mine(apart.segment)) place[std::size_t(apart.segment - first)] = apart.part;
  std::vector<std::int32_t> node(tree.resistance.size(), -1);
  Part part;
  const auto add = [&](std::int32_t segment) {
    for (; segment >= 0 && node[std::size_t(segment - first)] < 0;
         segment = anatomy_->segments[std::size_t(segment)].parent) {
      node[std::size_t(segment - first)] = 0;
      part.nodes.push_back({segment - first});
    }
  };
  for (const VesselInjury& injury : state.injuries)
    if (mine(injury.segment)) add(injury.segment);
  for (const VesselClip& clip : state.clips)
    if (mine(clip.segment)) add(clip.segment);
  if (!state.apart.empty())
    for (std::int32_t i = first; i < first + tree.range.count; ++i) {
      const std::int32_t parent = anatomy_->segments[std::size_t(i)].parent;
      if (parent >= 0 && place[std::size_t(i - first)] != place[std::size_t(parent - first)])
        add(parent);
    }
  std::ranges::sort(part.nodes, {}, &Part::Node::segment);
  for (std::size_t k = 0; k < part.nodes.size(); ++k)
    node[std::size_t(part.nodes[k].segment)] = std::int32_t(k);

  const bool clamped = state.inflowClamped && tree.supply.flow > 0;
  const auto feed = [&](std::int32_t from, std::int32_t to, double conductance, bool cutOff) {
    if (to == SegmentPart::kCrumb || !(conductance > 0)) return;
    part.feeds.push_back({from, to, conductance});
    if (!cutOff) fed[std::size_t(to)] = true;
  };
  for (std::size_t k = 0; k < part.nodes.size(); ++k) {
    Part::Node& n = part.nodes[k];
    const std::int32_t number = n.segment + first;
    const VesselSegment& s = anatomy_->segments[std::size_t(number)];
    if (s.parent >= 0) n.parent = node[std::size_t(s.parent - first)];
    bool severed = false;
    if (const VesselInjury* injury = state.injury(number)) {
      n.injury = std::int32_t(injury - state.injuries.data());
      severed = injury->severed();
    }
    n.shut = !severed && state.clipped(number);
    n.cutOff = severed || n.shut || (n.parent >= 0 && part.nodes[std::size_t(n.parent)].cutOff);
    const bool backwards = clamped || n.cutOff;
    const std::size_t i = std::size_t(n.segment);
    if (s.leaf)
      feed(std::int32_t(k), place[i],
           tree.leafConductance * (backwards && tree.supply.flow > 0 ? kBackwards : 1), n.cutOff);
    for (std::int32_t c = tree.firstChild[i]; c < tree.firstChild[i + 1]; ++c) {
      const std::size_t child = std::size_t(tree.children[std::size_t(c)]);
      if (node[child] < 0)
        feed(std::int32_t(k), place[child], tree.seen[backwards][child], n.cutOff);
    }
  }
  for (const std::int32_t root : tree.roots)
    if (node[std::size_t(root)] < 0)
      feed(-1, place[std::size_t(root)], tree.seen[clamped][std::size_t(root)], false);
  return part;
}

// One pass from the ends of the part up to the root, and one down. Adds to `into` what flows into
// the sinusoids, m^3/s, by part of the tissue. keep: writes the flows.
void VesselFlow::solveTree(const Tree& tree, Part& part, VesselState& state,
                           std::span<const EndOutside> outside, double sourceShare,
                           std::span<const double> sinusoids, bool keep, std::span<double> into,
                           double& air) const {
  using Node = Part::Node;
  const bool clamped = state.inflowClamped && tree.supply.flow > 0;
  const auto injuryAt = [&](const Node& n) -> VesselInjury& {
    return state.injuries[std::size_t(n.injury)];
  };
  for (Node& n : part.nodes) n.g = n.j = 0;
  double gRoot = 0, jRoot = 0;
  const auto join = [&](std::int32_t node, double g, double j) {
    (node < 0 ? gRoot : part.nodes[std::size_t(node)].g) += g;
    (node < 0 ? jRoot : part.nodes[std::size_t(node)].j) += j;
  };
  for (const Part::Feed& feed : part.feeds)
    join(feed.node, feed.conductance, feed.conductance * sinusoids[std::size_t(feed.place)]);
  // Where the outside pressure is higher, veins collapse: such an end was closed in this call,
  // unless it is a wide hepatic vein, which the tissue holds open, and which draws air. An end of
  // an injury lies beyond `resistance`.
  const auto openEnd = [&](const Node& n, int end, double resistance, double area) {
    const VesselInjury& injury = injuryAt(n);
    const EndOutside& out = outside[std::size_t(n.injury)];
    if (injury.isSealed(VesselEnd(end)) || out.closed[end] ||
        collapsed_[std::size_t(n.injury)][end] ||
        (injury.severed() && state.clipped(injury, VesselEnd(end))))
      return OpenEnd{};
    // Newton's tangent of R Q + k Q |Q| at the last flow.
    const double k = lossOf(area), last = injury.flow[end], size = std::abs(last);
    return OpenEnd{1 / (resistance + 2 * k * std::max(size, kLeastSpeed * area)),
                   out.pressure[end] - k * last * size};
  };
  struct Ends {
    double resistance, toRoot, toFar, area;  // toRoot, toFar: of the parts before and beyond
    OpenEnd open[2];
  };
  const auto endsOf = [&](const Node& n) {
    const VesselInjury& injury = injuryAt(n);
    const VesselSegment& s = anatomy_->segments[std::size_t(injury.segment)];
    Ends e;
    e.resistance = tree.resistance[std::size_t(n.segment)];
    e.toRoot = injury.from * e.resistance;
    e.toFar = (1 - injury.to) * e.resistance;
    e.area = std::numbers::pi * s.radius * s.radius * injury.share();
    const bool severed = injury.severed();
    e.open[0] = openEnd(n, 0, severed ? e.toRoot : 0, e.area);
    if (severed) e.open[1] = openEnd(n, 1, e.toFar, e.area);
    return e;
  };

  for (std::size_t k = part.nodes.size(); k-- > 0;) {
    Node& n = part.nodes[k];
    if (n.shut) continue;
    const double r = tree.resistance[std::size_t(n.segment)];
    if (n.injury < 0) {
      join(n.parent, behind(r, n.g), n.j / (1 + r * n.g));
      continue;
    }
    const Ends e = endsOf(n);
    const OpenEnd &near = e.open[0], &far = e.open[1];
    if (injuryAt(n).severed()) {
      n.g += far.g;
      n.j += far.g * far.pressure;
      join(n.parent, near.g, near.g * near.pressure);
    } else {  // a hole in the wall, between the parts before and beyond it
      const double g = behind(e.toFar, n.g) + near.g;
      const double j = n.j / (1 + e.toFar * n.g) + near.g * near.pressure;
      join(n.parent, behind(e.toRoot, g), j / (1 + e.toRoot * g));
    }
  }

  const double source = sourceShare * tree.supply.pressure;
  const double root =
      clamped ? (gRoot > 0 ? jRoot / gRoot : 0)
              : (source / tree.supply.resistance + jRoot) / (1 / tree.supply.resistance + gRoot);
  for (Node& n : part.nodes) {
    const double before = n.parent < 0 ? root : part.nodes[std::size_t(n.parent)].pressure;
    const double r = tree.resistance[std::size_t(n.segment)];
    const double alone = n.g > 0 ? n.j / n.g : 0;
    if (n.shut) {
      n.pressure = alone;
      if (keep && n.injury >= 0) injuryAt(n).flow[0] = injuryAt(n).flow[1] = 0;
      continue;
    }
    if (n.injury < 0) {
      n.pressure = (before + r * n.j) / (1 + r * n.g);
      continue;
    }
    const Ends e = endsOf(n);
    const OpenEnd &near = e.open[0], &far = e.open[1];
    double flow[2];
    if (injuryAt(n).severed()) {
      n.pressure = alone;
      flow[0] = near.g * (before - near.pressure);
      flow[1] = far.g * (n.pressure - far.pressure);
    } else {
      const double g = behind(e.toFar, n.g) + near.g;
      const double j = n.j / (1 + e.toFar * n.g) + near.g * near.pressure;
      const double hole = (before + e.toRoot * j) / (1 + e.toRoot * g);
      n.pressure = (hole + e.toFar * n.j) / (1 + e.toFar * n.g);
      flow[0] = near.g * (hole - near.pressure);
      flow[1] = 0;
    }
    if (!keep) continue;
    VesselInjury& injury = injuryAt(n);
    for (int end = 0; end < 2; ++end) {
      if (flow[end] < 0) {
        const bool wide = anatomy_->segments[std::size_t(injury.segment)].radius >= kHeldOpen;
        if (tree.supply.flow > 0 || !wide)
          collapsed_[std::size_t(n.injury)][end] = true, flow[end] = 0;
      }
      injury.flow[end] = std::clamp(flow[end], -kFastest * e.area, kFastest * e.area);
      air -= std::min(0.0, injury.flow[end]);
    }
  }
  if (keep) tree.inflow = clamped ? 0 : (source - root) / tree.supply.resistance;
  for (const Part::Feed& feed : part.feeds) {
    const double pressure = feed.node < 0 ? root : part.nodes[std::size_t(feed.node)].pressure;
    into[std::size_t(feed.place)] +=
        feed.conductance * (pressure - sinusoids[std::size_t(feed.place)]);
  }
}

double VesselFlow::solve(VesselState& state, std::span<const EndOutside> outside,
                         const SourceShares& sources, std::vector<double>& sinusoids) const {
  double air = 0;
  collapsed_.assign(state.injuries.size(), {false, false});
  std::size_t places = 1;
  for (const SegmentPart& apart : state.apart)
    places = std::max(places, std::size_t(apart.part + 1));
  sinusoids.resize(places, 0);
  std::vector<bool> fed(places, false);
  std::array<Part, kVesselKinds> parts;
  for (const VesselKind kind : kBlood)
    parts[std::size_t(kind)] = concernedPart(trees_[std::size_t(kind)], state, fed);
  for (const VesselKind kind : kBlood)
    std::erase_if(parts[std::size_t(kind)].feeds,
                  [&](const Part::Feed& feed) { return !fed[std::size_t(feed.place)]; });
  std::vector<std::size_t> unknown;  // parts of the tissue of which the pressure is sought
  for (std::size_t p = 0; p < places; ++p)
    if (fed[p])
      unknown.push_back(p);
    else
      sinusoids[p] = 0;

  const Eigen::Index count = Eigen::Index(unknown.size());
  std::vector<double> into(places);
  const auto flowInto = [&](const std::vector<double>& pressures, bool keep) {
    std::ranges::fill(into, 0.0);
    for (const VesselKind kind : kBlood)
      solveTree(trees_[std::size_t(kind)], parts[std::size_t(kind)], state, outside,
                kind == VesselKind::HepaticArtery ? sources.artery
                : kind == VesselKind::PortalVein  ? sources.portal
                                                  : sources.vein,
                pressures, keep, into, air);
    Eigen::VectorXd flow(count);
    for (Eigen::Index i = 0; i < count; ++i) flow[i] = into[unknown[std::size_t(i)]];
    return flow;
  };
  for (int round = 0; round < kRounds; ++round) {
    // The flows are affine in the pressures: those are sought at which nothing gathers.
    std::vector<double> probe(places, 0.0);
    const Eigen::VectorXd none = flowInto(probe, false);
    Eigen::MatrixXd gain(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      double& pressure = probe[unknown[std::size_t(i)]];
      pressure = kMmHg;
      gain.col(i) = (flowInto(probe, false) - none) / kMmHg;
      pressure = 0;
    }
    Eigen::VectorXd right = -none;
    for (Eigen::Index i = 0; i < count; ++i) {
      gain(i, i) -= kStays;
      right[i] -= kStays * sinusoids[unknown[std::size_t(i)]];
    }
    const Eigen::VectorXd pressures = gain.partialPivLu().solve(right);
    for (Eigen::Index i = 0; i < count; ++i) sinusoids[unknown[std::size_t(i)]] = pressures[i];
    air = 0;
    flowInto(sinusoids, true);
  }
  return air;
}

}  // namespace resect

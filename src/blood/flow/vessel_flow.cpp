#include "blood/flow/vessel_flow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace resect {
namespace {

constexpr double kJetLoss = 1.56;   // of a jet from a sharp end
constexpr double kBackwards = 0.2;  // what a leaf carries out of collapsing sinusoids
constexpr int kRounds = 4;
// m/s: a jet is not linear about a slower flow, since its tangent would have no resistance; and no
// pressure of the body drives blood out of an end faster.
constexpr double kLeastSpeed = 1e-4, kFastest = 5;
constexpr double kHeldOpen = 1.5e-3;  // m: radius from which hepatic veins stay open
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

// The part of a tree that injuries concern: their segments, those with clips, and those between
// them and the root.
struct VesselFlow::Part {
  struct Node {
    std::int32_t segment;      // within the tree
    std::int32_t parent = -1;  // index of its node; -1: the root
    std::int32_t injury = -1;  // index in VesselState::injuries
    bool shut = false;         // by a clip, without being severed
    bool backwards = false;    // what is beyond it is cut off from the source
    double healthy = 0;        // conductance from its end to the sinusoids, past other nodes
    double g = 0, j = 0;       // at its end: flow into what is beyond = g p - j
    double pressure = 0;       // at its end
  };
  std::vector<Node> nodes;  // ascending by segment
  double healthy = 0;       // of the roots that are no nodes
};

VesselFlow::Part VesselFlow::concernedPart(const Tree& tree, const VesselState& state) const {
  const std::int32_t first = tree.range.first;
  const auto mine = [&](std::int32_t segment) {
    return segment >= first && segment < first + tree.range.count;
  };
  std::vector<std::int32_t> node(tree.resistance.size(), -1);  // index by segment
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
  std::ranges::sort(part.nodes, {}, &Part::Node::segment);
  for (std::size_t k = 0; k < part.nodes.size(); ++k)
    node[std::size_t(part.nodes[k].segment)] = std::int32_t(k);

  const bool clamped = state.inflowClamped && tree.supply.flow > 0;
  for (Part::Node& n : part.nodes) {
    const std::int32_t number = n.segment + first;
    const VesselSegment& s = anatomy_->segments[std::size_t(number)];
    if (s.parent >= 0) n.parent = node[std::size_t(s.parent - first)];
    bool severed = false;
    if (const VesselInjury* injury = state.injury(number)) {
      n.injury = std::int32_t(injury - state.injuries.data());
      severed = injury->severed();
    }
    n.shut = !severed && state.clipped(number);
    n.backwards = clamped || severed || n.shut ||
                  (n.parent >= 0 && part.nodes[std::size_t(n.parent)].backwards);
    if (s.leaf)
      n.healthy += tree.leafConductance * (n.backwards && tree.supply.flow > 0 ? kBackwards : 1);
    const std::size_t i = std::size_t(n.segment);
    for (std::int32_t c = tree.firstChild[i]; c < tree.firstChild[i + 1]; ++c) {
      const std::size_t child = std::size_t(tree.children[std::size_t(c)]);
      if (node[child] < 0) n.healthy += tree.seen[n.backwards][child];
    }
  }
  for (const std::int32_t root : tree.roots)
    if (node[std::size_t(root)] < 0) part.healthy += tree.seen[clamped][std::size_t(root)];
  return part;
}

// One pass from the ends of the part up to the root, and one down. Returns what flows into the
// sinusoids, m^3/s. keep: writes the flows.
double VesselFlow::solveTree(const Tree& tree, Part& part, VesselState& state,
                             std::span<const EndOutside> outside, double sourceShare,
                             double sinusoids, bool keep, double& air) const {
  using Node = Part::Node;
  const bool clamped = state.inflowClamped && tree.supply.flow > 0;
  const auto injuryAt = [&](const Node& n) -> VesselInjury& {
    return state.injuries[std::size_t(n.injury)];
  };
  for (Node& n : part.nodes) n.g = n.j = 0;
  double gRoot = part.healthy, jRoot = part.healthy * sinusoids;
  const auto join = [&](std::int32_t node, double g, double j) {
    (node < 0 ? gRoot : part.nodes[std::size_t(node)].g) += g;
    (node < 0 ? jRoot : part.nodes[std::size_t(node)].j) += j;
  };
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
    // Newton's tangent of R Q + k Q^2 at the last flow.
    const double k = lossOf(area), last = std::max(injury.flow[end], kLeastSpeed * area);
    return OpenEnd{1 / (resistance + 2 * k * last), out.pressure[end] - k * last * last};
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
    n.g += n.healthy;
    n.j += n.healthy * sinusoids;
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
  const double inflow = clamped ? 0 : (source - root) / tree.supply.resistance;
  double out = 0;
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
    out += flow[0] + flow[1];
    if (!keep) continue;
    VesselInjury& injury = injuryAt(n);
    for (int end = 0; end < 2; ++end) {
      if (flow[end] < 0) {
        const bool wide = anatomy_->segments[std::size_t(injury.segment)].radius >= kHeldOpen;
        if (tree.supply.flow < 0 && wide)
          air -= flow[end];
        else
          collapsed_[std::size_t(n.injury)][end] = true;
      }
      injury.flow[end] = std::clamp(flow[end], 0.0, kFastest * e.area);
    }
  }
  if (keep) tree.inflow = inflow;
  return inflow - out;
}

double VesselFlow::solve(VesselState& state, std::span<const EndOutside> outside,
                         const SourceShares& sources, double& sinusoids) const {
  double air = 0;
  collapsed_.assign(state.injuries.size(), {false, false});
  std::array<Part, kVesselKinds> parts;
  for (const VesselKind kind : kBlood)
    parts[std::size_t(kind)] = concernedPart(trees_[std::size_t(kind)], state);
  for (int round = 0; round < kRounds; ++round) {
    air = 0;
    const auto net = [&](double pressure, bool keep) {  // flow into the sinusoids
      double sum = 0;
      for (const VesselKind kind : kBlood)
        sum += solveTree(trees_[std::size_t(kind)], parts[std::size_t(kind)], state, outside,
                         kind == VesselKind::HepaticArtery ? sources.artery
                         : kind == VesselKind::PortalVein  ? sources.portal
                                                           : 1,
                         pressure, keep, air);
      return sum;
    };
    const double none = net(0, false), unit = net(kMmHg, false);  // it is affine in the pressure
    if (unit < none) sinusoids = none / (none - unit) * kMmHg;
    net(sinusoids, true);
  }
  return air;
}

}  // namespace resect

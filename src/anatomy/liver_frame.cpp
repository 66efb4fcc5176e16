#include "anatomy/liver_frame.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "base/elementary.h"

namespace resect {
namespace {

constexpr std::int32_t kFewestTerminals = 20;
constexpr double kMainBranch = 0.05;  // of all terminals, from which a portal branch is a main one
constexpr double kShortestAxis = 0.001;  // m: of the line from the portal vein to the hepatic veins
constexpr double kMainVein = 0.08;  // of all terminals, from which a hepatic vein is a main one

// Segments of a kind that begin where `parent` ends; at the roots if it is -1.
std::vector<std::int32_t> childrenOf(const Anatomy& anatomy, VesselKind kind, std::int32_t parent) {
  std::vector<std::int32_t> found;
  const VesselRange range = anatomy.range(kind);
  for (std::int32_t i = range.first; i < range.first + range.count; ++i)
    if (anatomy.segments[std::size_t(i)].parent == parent) found.push_back(i);
  return found;
}

// Where the portal vein divides: the first fork of which two branches are main ones.
std::optional<std::int32_t> portalFork(const Anatomy& anatomy,
                                       const std::vector<std::int32_t>& terminals) {
  const auto size = [&](std::int32_t i) { return terminals[std::size_t(i)]; };
  std::vector<std::int32_t> next = childrenOf(anatomy, VesselKind::PortalVein, -1);
  if (next.empty()) return std::nullopt;
  std::int32_t at = *std::ranges::max_element(next, {}, size);
  const std::int32_t all = size(at);
  if (all < kFewestTerminals) return std::nullopt;
  for (;;) {
    next = childrenOf(anatomy, VesselKind::PortalVein, at);
    const auto main =
        std::ranges::count_if(next, [&](std::int32_t i) { return size(i) > kMainBranch * all; });
    if (main >= 2 || next.empty()) return at;
    at = *std::ranges::max_element(next, {}, size);
  }
}

// The three main hepatic veins: subtrees, the largest of which is divided until there are three.
std::vector<std::int32_t> hepaticTrunks(const Anatomy& anatomy,
                                        const std::vector<std::int32_t>& terminals) {
  std::vector<std::int32_t> trunks = childrenOf(anatomy, VesselKind::HepaticVein, -1);
  const auto size = [&](std::int32_t i) { return terminals[std::size_t(i)]; };
  std::int32_t all = 0;
  for (const std::int32_t root : trunks) all += size(root);
  for (int i = 0; i < 1000 && !trunks.empty(); ++i) {
    std::ranges::sort(trunks, std::ranges::greater(), size);
    if (trunks.size() >= 3 && size(trunks[2]) >= kMainVein * all)
      return {trunks.begin(), trunks.begin() + 3};
    const std::vector<std::int32_t> next =
        childrenOf(anatomy, VesselKind::HepaticVein, trunks.front());
    trunks.erase(trunks.begin());
    trunks.insert(trunks.end(), next.begin(), next.end());
  }
  return {};
}

// The direction, at a right angle to the axis, on whose side least of the liver lies. Each of 72
// directions has a sum over the portal terminals within 60 degrees of it: the distances, along the
// direction, of these terminals from the axis. The result is the direction with the least sum.
Vec3 emptiestSide(const Anatomy& anatomy, const LiverFrame& frame) {
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  constexpr int kDirections = 72;
  double least = std::numeric_limits<double>::infinity();
  Vec3 emptiest = frame.ahead;
  for (int k = 0; k < kDirections; ++k) {
    const double turn = 2 * std::numbers::pi * k / kDirections;
    const Vec3 side = math::cos(turn) * frame.ahead + math::sin(turn) * frame.left;
    double sum = 0;
    for (std::int32_t i = portal.first; i < portal.first + portal.count; ++i) {
      const VesselSegment& s = anatomy.segments[std::size_t(i)];
      const Vec3 way = s.end - frame.cava;
      const Vec3 out = way - way.dot(frame.up) * frame.up;
      if (s.leaf && out.dot(side) > 0.5 * out.norm()) sum += out.dot(side);
    }
    if (sum < least) least = sum, emptiest = side;
  }
  return emptiest;
}

// Mean angle of a hepatic vein's segments, in which wide ones count more.
double angleOf(const Anatomy& anatomy, const LiverFrame& frame, std::int32_t trunk) {
  const VesselRange range = anatomy.range(VesselKind::HepaticVein);
  std::vector<std::uint8_t> own(anatomy.segments.size(), 0);
  own[std::size_t(trunk)] = 1;
  double sum = 0, weight = 0;
  for (std::int32_t i = trunk; i < range.first + range.count; ++i) {
    const VesselSegment& s = anatomy.segments[std::size_t(i)];
    if (s.parent >= 0 && own[std::size_t(s.parent)]) own[std::size_t(i)] = 1;
    if (!own[std::size_t(i)]) continue;
    const double w = s.radius * s.radius * s.length();
    sum += w * frame.angle(s.at(0.5)), weight += w;
  }
  return weight > 0 ? sum / weight : 0;
}

}  // namespace

std::vector<std::int32_t> terminalsOf(const Anatomy& anatomy) {
  std::vector<std::int32_t> count(anatomy.segments.size(), 0);
  for (std::size_t i = anatomy.segments.size(); i-- > 0;) {
    const VesselSegment& s = anatomy.segments[i];
    count[i] += s.leaf;
    if (s.parent >= 0) count[std::size_t(s.parent)] += count[i];
  }
  return count;
}

double LiverFrame::angle(const Vec3& place) const {
  const Vec3 way = place - cava;
  return math::atan2(way.dot(left), way.dot(ahead));
}

std::optional<LiverFrame> LiverFrame::find(const Anatomy& anatomy) {
  const std::vector<std::int32_t> terminals = terminalsOf(anatomy);
  const auto fork = portalFork(anatomy, terminals);
  const std::vector<std::int32_t> trunks = hepaticTrunks(anatomy, terminals);
  if (!fork || trunks.size() < 3) return std::nullopt;
  LiverFrame frame;
  frame.fork = anatomy.segments[std::size_t(*fork)].end;
  for (const std::int32_t t : trunks) frame.cava += anatomy.segments[std::size_t(t)].start / 3;
  std::int32_t root = *fork;
  while (anatomy.segments[std::size_t(root)].parent >= 0)
    root = anatomy.segments[std::size_t(root)].parent;
  frame.entry = anatomy.segments[std::size_t(root)].start;
  if ((frame.cava - frame.entry).norm() < kShortestAxis) return std::nullopt;
  frame.up = (frame.cava - frame.entry).normalized();
  // First any direction at a right angle to the axis, then the one away from the emptiest side.
  int least = 0;
  frame.up.cwiseAbs().minCoeff(&least);
  frame.ahead = frame.up.cross(Vec3::Unit(least)).normalized();
  frame.left = frame.up.cross(frame.ahead);
  frame.ahead = -emptiestSide(anatomy, frame);
  frame.left = frame.up.cross(frame.ahead);
  std::array<std::pair<double, std::int32_t>, 3> byAngle;
  for (std::size_t k = 0; k < 3; ++k) byAngle[k] = {angleOf(anatomy, frame, trunks[k]), trunks[k]};
  std::ranges::sort(byAngle);
  for (std::size_t k = 0; k < 3; ++k) frame.trunks[k] = byAngle[k].second;
  return frame;
}

}  // namespace resect

#include "anatomy/liver_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"

namespace resect {
namespace {

constexpr std::int64_t kFewestTerminals = 20;
constexpr double kMainBranch = 0.08;  // of all terminals, from which a hepatic vein is a main one
constexpr double kAtOnce = 0.012;     // m: from a fork of the portal vein to the next one
constexpr double kCaudate = 0.025;    // m: radius of the caudate round its axis (setting)
// Share of the terminals of a section that lie above and below its border at least, however low or
// high the portal vein forks.
constexpr double kLeastPart = 0.3;

// Terminals of each subtree, by segment.
std::vector<std::int64_t> terminalsOf(const Anatomy& anatomy) {
  std::vector<std::int64_t> count(anatomy.segments.size(), 0);
  for (std::size_t i = anatomy.segments.size(); i-- > 0;) {
    const VesselSegment& s = anatomy.segments[i];
    if (s.leaf) ++count[i];
    if (s.parent >= 0) count[std::size_t(s.parent)] += count[i];
  }
  return count;
}

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
                                       const std::vector<std::int64_t>& terminals) {
  std::vector<std::int32_t> roots = childrenOf(anatomy, VesselKind::PortalVein, -1);
  if (roots.empty()) return std::nullopt;
  const auto most = [&](const std::vector<std::int32_t>& some) {
    return *std::ranges::max_element(some, {},
                                     [&](std::int32_t i) { return terminals[std::size_t(i)]; });
  };
  std::int32_t at = most(roots);
  const double all = double(terminals[std::size_t(at)]);
  if (all < kFewestTerminals) return std::nullopt;
  for (;;) {
    const std::vector<std::int32_t> next = childrenOf(anatomy, VesselKind::PortalVein, at);
    const auto main = std::ranges::count_if(
        next, [&](std::int32_t i) { return double(terminals[std::size_t(i)]) > 0.15 * all; });
    if (main >= 2 || next.empty()) return at;
    at = most(next);
  }
}

// The three main hepatic veins: subtrees, the largest of which is divided until there are three.
std::vector<std::int32_t> hepaticTrunks(const Anatomy& anatomy,
                                        const std::vector<std::int64_t>& terminals) {
  std::vector<std::int32_t> trunks = childrenOf(anatomy, VesselKind::HepaticVein, -1);
  const auto size = [&](std::int32_t i) { return terminals[std::size_t(i)]; };
  std::int64_t all = 0;
  for (const std::int32_t root : trunks) all += size(root);
  for (int i = 0; i < 1000 && !trunks.empty(); ++i) {
    std::ranges::sort(trunks, std::ranges::greater(), size);
    if (trunks.size() >= 3 && double(size(trunks[2])) >= kMainBranch * double(all))
      return {trunks.begin(), trunks.begin() + 3};
    const std::vector<std::int32_t> next =
        childrenOf(anatomy, VesselKind::HepaticVein, trunks.front());
    trunks.erase(trunks.begin());
    trunks.insert(trunks.end(), next.begin(), next.end());
  }
  return {};
}

// The height above which a share of 0 to 1 of the heights lies; sorts them.
double quantile(std::vector<double>& heights, double share) {
  std::ranges::sort(heights);
  return heights[std::min(heights.size() - 1, std::size_t(share * double(heights.size())))];
}

}  // namespace

double LiverSegments::angle(const Vec3& place) const {
  const Vec3 way = place - cava_;
  return math::atan2(way.dot(left_), way.dot(ahead_));
}

// Of the nearest terminals each has a vote, which counts the more the nearer it is.
LiverSegments::Section LiverSegments::sectionAt(const Vec3& place) const {
  constexpr std::size_t kVotes = 12;
  constexpr double kNear = 0.01;  // m: no terminal counts much more than one at this distance
  std::array<std::pair<double, Section>, kVotes> nearest;
  nearest.fill({std::numeric_limits<double>::infinity(), Section::Left});
  for (const Terminal& t : terminals_) {
    const double d = (t.end - place).squaredNorm();
    if (d >= nearest.back().first) continue;
    std::size_t k = kVotes - 1;
    for (; k > 0 && nearest[k - 1].first > d; --k) nearest[k] = nearest[k - 1];
    nearest[k] = {d, t.section};
  }
  std::array<double, 3> votes{};
  for (const auto& [d, section] : nearest) votes[std::size_t(section)] += 1 / (d + kNear * kNear);
  return Section(std::ranges::max_element(votes) - votes.begin());
}

int LiverSegments::at(const Vec3& place) const {
  // The caudate: round the line from the fork to the cava, on the cava's side of it.
  const Vec3 line = cava_ - fork_, way = place - fork_;
  const double share = std::clamp(way.dot(line) / line.squaredNorm(), 0.0, 1.0);
  if (share > 0 && (way - share * line).norm() < kCaudate && way.dot(ahead_) < 0) return 1;
  const Section section = sectionAt(place);
  if (section == Section::Left && angle(place) < veins_[2]) return 4;
  const bool upper = height(place) > levels_[section == Section::Left];
  switch (section) {
    case Section::Posterior:
      return upper ? 7 : 6;
    case Section::Anterior:
      return upper ? 8 : 5;
    default:
      return upper ? 2 : 3;
  }
}

std::optional<LiverSegments> LiverSegments::find(const Anatomy& anatomy) {
  const std::vector<std::int64_t> terminals = terminalsOf(anatomy);
  const auto fork = portalFork(anatomy, terminals);
  const std::vector<std::int32_t> trunks = hepaticTrunks(anatomy, terminals);
  if (!fork || trunks.size() < 3) return std::nullopt;
  LiverSegments found;
  found.fork_ = anatomy.segments[std::size_t(*fork)].end;
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  for (std::int32_t i = portal.first; i < portal.first + portal.count; ++i)
    if (anatomy.segments[std::size_t(i)].leaf)
      found.terminals_.push_back({anatomy.segments[std::size_t(i)].end});
  found.setAxes(anatomy, trunks);
  found.setSections(anatomy, *fork);
  found.setLevels();
  found.nameVessels(anatomy);
  return found;
}

// Axes, the angles of the hepatic veins, and which vein each segment of them belongs to.
void LiverSegments::setAxes(const Anatomy& anatomy, const std::vector<std::int32_t>& trunks) {
  for (const std::int32_t t : trunks) cava_ += anatomy.segments[std::size_t(t)].start / 3;
  up_ = (cava_ - fork_).normalized();
  Vec3 ahead = -cava_;
  for (const Terminal& t : terminals_) ahead += t.end / double(terminals_.size());
  ahead_ = (ahead - ahead.dot(up_) * up_).normalized();
  left_ = up_.cross(ahead_);

  // The veins' courses: their middles, where wide pieces count more.
  const VesselRange hepatic = anatomy.range(VesselKind::HepaticVein);
  trunk_.assign(anatomy.segments.size(), -1);
  std::array<Vec3, 3> sum{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::array<double, 3> weight{};
  for (std::int32_t i = hepatic.first; i < hepatic.first + hepatic.count; ++i) {
    const VesselSegment& s = anatomy.segments[std::size_t(i)];
    const auto own = std::ranges::find(trunks, i);
    std::int8_t& trunk = trunk_[std::size_t(i)];
    if (own != trunks.end())
      trunk = std::int8_t(own - trunks.begin());
    else if (s.parent >= 0)
      trunk = trunk_[std::size_t(s.parent)];
    if (trunk < 0) continue;
    const double w = s.radius * s.radius * s.radius * s.radius * s.length();
    sum[std::size_t(trunk)] += w * s.at(0.5);
    weight[std::size_t(trunk)] += w;
  }
  std::array<int, 3> order{0, 1, 2};
  std::array<double, 3> turn{};
  for (std::size_t t = 0; t < 3; ++t) turn[t] = angle(sum[t] / weight[t]);
  std::ranges::sort(order, {}, [&](int t) { return turn[std::size_t(t)]; });
  const double middle = turn[std::size_t(order[1])];
  const auto beyond =
      std::ranges::count_if(terminals_, [&](const Terminal& t) { return angle(t.end) > middle; });
  if (2 * beyond > std::ssize(terminals_)) {  // what was taken for left is the larger side
    left_ = -left_;
    for (double& t : turn) t = -t;
    std::ranges::reverse(order);
  }
  std::array<std::int8_t, 3> place{};
  for (std::size_t k = 0; k < 3; ++k) {
    veins_[k] = turn[std::size_t(order[k])];
    place[std::size_t(order[k])] = std::int8_t(k);
  }
  for (std::int8_t& t : trunk_)
    if (t >= 0) t = place[std::size_t(t)];
}

// The territories of the portal vein's branches.
void LiverSegments::setSections(const Anatomy& anatomy, std::int32_t fork) {
  const std::vector<std::int64_t> count = terminalsOf(anatomy);
  std::vector<double> turn(anatomy.segments.size(), 0);  // sum over a subtree's terminals
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  for (std::int32_t i = portal.first + portal.count; i-- > portal.first;) {
    const VesselSegment& s = anatomy.segments[std::size_t(i)];
    if (s.leaf) turn[std::size_t(i)] += angle(s.end);
    if (s.parent >= 0) turn[std::size_t(s.parent)] += turn[std::size_t(i)];
  }
  const auto meanTurn = [&](std::int32_t i) {
    return turn[std::size_t(i)] / double(std::max<std::int64_t>(1, count[std::size_t(i)]));
  };
  // Main branches where a vessel divides, the rightmost first.
  const auto branches = [&](std::int32_t at, double least) {
    std::vector<std::int32_t> next = childrenOf(anatomy, VesselKind::PortalVein, at);
    std::erase_if(next, [&](std::int32_t i) {
      return double(count[std::size_t(i)]) < least * double(count[std::size_t(at)]);
    });
    std::ranges::sort(next, {}, meanTurn);
    return next;
  };
  // Branches of a branch that divides again at once, as where three branches leave nearly together.
  const auto dividesAtOnce = [&](std::int32_t branch) {
    const double least =
        0.15 * double(count[std::size_t(fork)]) / double(count[std::size_t(branch)]);
    double way = 0;
    for (;;) {
      way += anatomy.segments[std::size_t(branch)].length();
      std::vector<std::int32_t> next = branches(branch, least);
      if (way > kAtOnce || next.empty()) return std::vector<std::int32_t>{};
      if (next.size() > 1) return next;
      branch = next.front();
    }
  };
  std::vector<std::int32_t> main = branches(fork, 0.15);
  for (std::size_t b = 0; b < 2 && main.size() == 2; ++b)
    if (const auto next = dividesAtOnce(main[b]); next.size() == 2) {
      main.erase(main.begin() + std::ptrdiff_t(b));
      main.insert(main.end(), next.begin(), next.end());
      std::ranges::sort(main, {}, meanTurn);
    }
  std::vector<Section> section(anatomy.segments.size(), Section::Anterior);
  if (main.size() >= 2) {
    section[std::size_t(main.back())] = Section::Left;
    std::int32_t right = main.front();
    if (main.size() == 2) {  // one right branch: its rightmost branch where it divides
      std::vector<std::int32_t> next = branches(right, 0.2);
      while (next.size() == 1) right = next.front(), next = branches(right, 0.2);
      if (!next.empty()) right = next.front();
    }
    section[std::size_t(right)] = Section::Posterior;
  }
  // Branches inherit.
  std::size_t terminal = 0;
  for (std::int32_t i = portal.first; i < portal.first + portal.count; ++i) {
    const VesselSegment& s = anatomy.segments[std::size_t(i)];
    Section& own = section[std::size_t(i)];
    if (s.parent >= 0 && own == Section::Anterior) own = section[std::size_t(s.parent)];
    if (s.leaf) terminals_[terminal++].section = own;
  }
}

// Upper and lower segments are parted level with the fork.
void LiverSegments::setLevels() {
  for (const bool left : {false, true}) {
    std::vector<double> heights;
    for (const Terminal& t : terminals_)
      if ((t.section == Section::Left) == left && (!left || angle(t.end) >= veins_[2]))
        heights.push_back(height(t.end));
    if (heights.empty()) continue;
    const double low = quantile(heights, kLeastPart), high = quantile(heights, 1 - kLeastPart);
    levels_[left] = std::clamp(0.0, low, high);
  }
}

}  // namespace resect

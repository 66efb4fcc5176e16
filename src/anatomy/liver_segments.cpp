#include "anatomy/liver_segments.h"

#include <algorithm>

#include "anatomy/liver_borders.h"

namespace resect {
namespace {

// Shares of the liver: settings, so chosen that the segments have the order of size, and VIII the
// share, of the medians of 107 livers (Mise et al. 2014, doi:10.1111/hpb.12157).
constexpr double kCaudate = 0.04;            // I, of all
constexpr PartShare kRight{0.67, 0.07};      // right liver, of all but I
constexpr PartShare kPosterior{0.40, 0.08};  // VI and VII, of the right liver
constexpr PartShare kMedial{0.47, 0.08};     // IV, of the left liver
constexpr PartShare kSix{0.35, 0.06}, kFive{0.34, 0.07}, kThree{0.55, 0.06};  // of their sections

// The caudate lies round a line that runs this far behind the portal vein's beginning and the place
// where the hepatic veins meet, m.
constexpr double kCaudateBehind = 0.012;
// The part of this line near which the caudate lies, as shares of the line's length from below.
constexpr double kCaudateFoot = 0.3, kCaudateTop = 0.7;
// A branch belongs to one segment as a whole if this share of its terminals does.
constexpr double kWhole = 0.85;

}  // namespace

int LiverSegments::at(const Vec3& place) const {
  constexpr double kNear = 0.01;  // m: no terminal counts much more than one at this distance
  std::array<double, kLiverSegments> votes{};
  for (const auto& [squared, terminal] : nearest_(place))
    votes[std::size_t(terminals_[std::size_t(terminal)].segment - 1)] +=
        1 / (squared + kNear * kNear);
  return int(std::ranges::max_element(votes) - votes.begin()) + 1;
}

int LiverSegments::nearestSegment(const Vec3& place) const {
  return terminals_[std::size_t(nearest_(place)[0].place)].segment;
}

std::optional<LiverSegments> LiverSegments::find(const Anatomy& anatomy) {
  const auto frame = LiverFrame::find(anatomy);
  if (!frame) return std::nullopt;
  LiverSegments found;
  found.frame_ = *frame;
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  for (std::int32_t i = portal.first; i < portal.first + portal.count; ++i)
    if (const VesselSegment& s = anatomy.segments[std::size_t(i)]; s.leaf)
      found.terminals_.push_back({s.end, i, 0});
  std::vector<Vec3> ends;
  for (const Terminal& t : found.terminals_) ends.push_back(t.end);
  found.nearest_ = EightNearest(std::move(ends));
  found.takeCaudate();
  found.divide(anatomy);
  found.followBranches(anatomy);
  found.nameVessels(anatomy);
  return found;
}

void LiverSegments::takeCaudate() {
  std::vector<double> angles;
  for (const Terminal& t : terminals_) angles.push_back(frame_.angle(t.end));
  const auto third = angles.begin() + std::ptrdiff_t(angles.size() / 3);
  std::ranges::nth_element(angles, third);
  const double rightmost = *third;  // none of the caudate is in the third of the liver on its right
  const Vec3 line = frame_.cava - frame_.entry, foot = frame_.entry - kCaudateBehind * frame_.ahead;
  std::vector<std::pair<double, std::size_t>> near;  // distance, index of the terminal
  for (std::size_t i = 0; i < terminals_.size(); ++i) {
    if (frame_.angle(terminals_[i].end) < rightmost) continue;
    const Vec3 way = terminals_[i].end - foot;
    const double share = std::clamp(way.dot(line) / line.squaredNorm(), kCaudateFoot, kCaudateTop);
    near.push_back({(way - share * line).norm(), i});
  }
  std::ranges::sort(near);
  near.resize(std::max<std::size_t>(1, std::size_t(kCaudate * double(terminals_.size()) + 0.5)));
  for (const auto& [distance, i] : near) terminals_[i].segment = 1;
}

// Parts the terminals in two, and these again, until each belongs to a segment.
void LiverSegments::divide(const Anatomy& anatomy) {
  // Of the terminals with the number `all`, those below the border get the number `first`, and the
  // others the number `second`.
  const auto part = [&](int all, int first, int second, const auto& valueOf, const auto& best) {
    std::vector<double> values;
    for (const Terminal& t : terminals_)
      if (t.segment == all) values.push_back(valueOf(t));
    const double border = best(values);
    for (Terminal& t : terminals_)
      if (t.segment == all) t.segment = valueOf(t) < border ? first : second;
  };
  const auto sideways = [&](int all, int right, int left, const PartShare& share) {
    part(
        all, right, left, [&](const Terminal& t) { return frame_.angle(t.end); },
        [&](const auto& angles) { return bestPlane(anatomy, frame_, angles, share); });
  };
  const auto upwards = [&](int all, int lower, int upper, const PartShare& share) {
    part(
        all, lower, upper, [&](const Terminal& t) { return frame_.height(t.end); },
        [&](const auto& heights) { return bestLevel(heights, share); });
  };
  sideways(0, 5, 4, kRight);
  sideways(5, 6, 5, kPosterior);
  sideways(4, 4, 3, kMedial);
  upwards(6, 6, 7, kSix);
  upwards(5, 5, 8, kFive);
  upwards(3, 3, 2, kThree);
}

// Gives branches to segments as a whole. The caudate, which has many small branches and no large
// one, keeps its terminals and gets no others.
void LiverSegments::followBranches(const Anatomy& anatomy) {
  std::vector<std::array<int, kLiverSegments>> ends(anatomy.segments.size());  // of each subtree
  for (const Terminal& t : terminals_)
    if (t.segment > 1) ++ends[std::size_t(t.vessel)][std::size_t(t.segment - 1)];
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  for (std::int32_t i = portal.first + portal.count; i-- > portal.first;)
    if (const std::int32_t parent = anatomy.segments[std::size_t(i)].parent; parent >= 0)
      for (std::size_t k = 0; k < kLiverSegments; ++k)
        ends[std::size_t(parent)][k] += ends[std::size_t(i)][k];
  std::vector<int> whole(anatomy.segments.size(), 0);
  for (std::int32_t i = portal.first; i < portal.first + portal.count; ++i) {
    const std::int32_t parent = anatomy.segments[std::size_t(i)].parent;
    int& own = whole[std::size_t(i)];
    if (parent >= 0) own = whole[std::size_t(parent)];
    if (own) continue;
    const auto& count = ends[std::size_t(i)];
    int all = 0;
    for (const int n : count) all += n;
    const auto most = std::ranges::max_element(count);
    if (*most > 0 && *most >= kWhole * all) own = int(most - count.begin()) + 1;
  }
  for (Terminal& t : terminals_)
    if (t.segment > 1) t.segment = whole[std::size_t(t.vessel)];
}

}  // namespace resect

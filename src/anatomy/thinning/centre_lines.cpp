#include "anatomy/thinning/centre_lines.h"

#include <algorithm>

#include "anatomy/thinning/skeleton.h"

namespace resect {
namespace {

constexpr double kStraight = 0.35;  // radii: how far a segment may leave the centre line
constexpr double kLongest = 6;      // radii: longest segment, so that radii follow the vessel
constexpr double kShortest = 1;     // radii: shortest segment on the way between two branches

struct LinePoint {
  Vec3 place;
  double radius;
};

// Steps of the lattice shake a line; each point but the ends goes towards its neighbours.
void smooth(std::vector<LinePoint>& line) {
  for (int round = 0; round < 3; ++round) {
    const std::vector<LinePoint> before = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      line[i].place = 0.25 * (before[i - 1].place + 2 * before[i].place + before[i + 1].place);
  }
}

// Within the vessel that a branch leaves, depths are those of that vessel.
void takeOwnRadii(std::vector<LinePoint>& line) {
  std::size_t own = 0;
  while (own + 1 < line.size() &&
         (line[own].place - line[0].place).norm() < std::min(line[0].radius, line[own].radius * 2))
    ++own;
  for (std::size_t i = 0; i < own; ++i) line[i].radius = std::min(line[i].radius, line[own].radius);
}

// Goes straight on from the last point to the wall of the vessel's end.
void goOn(std::vector<LinePoint>& line) {
  const LinePoint last = line.back();
  std::size_t before = line.size() - 2;
  while (before > 0 && (last.place - line[before].place).norm() < 2 * last.radius) --before;
  const Vec3 way = (last.place - line[before].place).normalized();
  line.push_back({last.place + last.radius * way, last.radius});
}

double meanRadius(const std::vector<LinePoint>& line, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i <= last; ++i) sum += line[i].radius;
  return sum / double(last - first + 1);
}

// The last point that a straight segment from `first` may reach.
std::size_t segmentEnd(const std::vector<LinePoint>& line, std::size_t first) {
  std::size_t end = first + 1;
  for (std::size_t last = end + 1; last < line.size(); ++last) {
    const Vec3 from = line[first].place, way = line[last].place - from;
    const double radius = meanRadius(line, first, last), length = way.norm();
    double off = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double share =
          length > 0 ? std::clamp((line[i].place - from).dot(way) / (length * length), 0.0, 1.0)
                     : 0;
      off = std::max(off, (line[i].place - from - share * way).norm());
    }
    if (length > kShortest * radius && (off > kStraight * radius || length > kLongest * radius))
      break;
    end = last;
  }
  return end;
}

class SegmentMaker {
 public:
  SegmentMaker(const SolidShape& shape, VesselKind kind, const Skeleton& skeleton)
      : shape_(shape), kind_(kind), skeleton_(skeleton), children_(skeleton.cells.size()) {
    for (std::size_t i = 1; i < skeleton.cells.size(); ++i)
      children_[std::size_t(skeleton.parents[i])].push_back(int(i));
  }

  void addTo(std::vector<VesselSegment>& segments) const {
    struct Branch {
      int from, next;       // its first cells
      std::int32_t parent;  // the segment that it leaves
    };
    std::vector<Branch> open;
    for (const int child : children_[0]) open.push_back({0, child, -1});
    for (std::size_t b = 0; b < open.size(); ++b) {
      std::vector<LinePoint> line{point(open[b].from), point(open[b].next)};
      int at = open[b].next;
      while (children_[std::size_t(at)].size() == 1) {
        at = children_[std::size_t(at)][0];
        line.push_back(point(at));
      }
      const bool leaf = children_[std::size_t(at)].empty();
      const std::int32_t last =
          addLine(std::move(line), children_[0].size() == 1 && open[b].from == 0, leaf,
                  open[b].parent, segments);
      segments[std::size_t(last)].leaf = leaf;
      for (const int child : children_[std::size_t(at)]) open.push_back({at, child, last});
    }
  }

 private:
  LinePoint point(int i) const {
    const std::int64_t cell = skeleton_.cells[std::size_t(i)];
    return {shape_.lattice.centre(shape_.lattice.cell(cell)),
            std::max<double>(shape_.depth[std::size_t(cell)], 0.5 * shape_.cell())};
  }

  // atRoot, atLeaf: whether the line begins at the root, and whether it ends the vessel.
  std::int32_t addLine(std::vector<LinePoint> line, bool atRoot, bool atLeaf, std::int32_t parent,
                       std::vector<VesselSegment>& segments) const {
    smooth(line);
    if (!atRoot) takeOwnRadii(line);
    if (atLeaf) goOn(line);
    if (atRoot) {
      std::ranges::reverse(line);
      goOn(line);
      std::ranges::reverse(line);
    }
    for (std::size_t first = 0; first + 1 < line.size();) {
      const std::size_t last = segmentEnd(line, first);
      segments.push_back({kind_, parent, line[first].place, line[last].place,
                          meanRadius(line, first, last), false});
      parent = std::int32_t(segments.size()) - 1;
      first = last;
    }
    return parent;
  }

  const SolidShape& shape_;
  VesselKind kind_;
  const Skeleton& skeleton_;
  std::vector<std::vector<int>> children_;
};

}  // namespace

std::vector<VesselSegment> centreLines(const SolidShape& shape, VesselKind kind) {
  std::vector<VesselSegment> segments;
  std::vector<Skeleton> trees = skeletons(shape);
  if (kind == VesselKind::HepaticVein) rootTogether(shape, trees);
  for (const Skeleton& skeleton : trees) SegmentMaker(shape, kind, skeleton).addTo(segments);
  return segments;
}

}  // namespace resect

// What must be true of Couinaud's segments in any liver whose box has the patient's directions:
// left at +x, up at +y, to the front at +z.
#pragma once

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <set>

#include "anatomy/liver_segments.h"
#include "collision/signed_distance.h"

namespace resect::test {

// Segments of points of a regular grid, 0 outside the liver.
struct SegmentGrid {
  Vec3 first = Vec3::Zero();
  double spacing = 0.005;  // m
  Vec3i count = Vec3i::Zero();
  std::vector<int> segments;  // x fastest

  SegmentGrid(const LiverSegments& found, const TriangleMesh& liver) {
    const SignedDistance distance(liver, 0.01, spacing);
    const Aabb box = bounds(liver);
    first = box.min;
    count = (box.size() / spacing).array().ceil().cast<int>();
    segments.resize(std::size_t(count.prod()));
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (distance(place(i)).distance < 0) segments[i] = found.at(place(i));
  }
  Vec3i coordinates(std::size_t i) const {
    const int x = int(i) % count.x(), y = int(i) / count.x() % count.y();
    return Vec3i(x, y, int(i) / (count.x() * count.y()));
  }
  Vec3 place(std::size_t i) const { return first + spacing * coordinates(i).cast<double>(); }
  std::size_t index(const Vec3i& c) const {
    return std::size_t((c.z() * count.y() + c.y()) * count.x() + c.x());
  }
  // Points of the largest part of a segment in which neighbours have a face in common.
  std::int64_t largestPart(int segment) const {
    std::vector<std::uint8_t> seen(segments.size(), 0);
    std::int64_t largest = 0;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (segments[i] != segment || seen[i]) continue;
      std::int64_t points = 0;
      for (open = {i}, seen[i] = 1; !open.empty(); ++points) {
        const Vec3i at = coordinates(open.back());
        open.pop_back();
        for (int axis = 0; axis < 3; ++axis)
          for (const int step : {-1, 1}) {
            const Vec3i next = at + step * Vec3i::Unit(axis);
            if (next[axis] < 0 || next[axis] >= count[axis]) continue;
            const std::size_t n = index(next);
            if (segments[n] == segment && !seen[n]) seen[n] = 1, open.push_back(n);
          }
      }
      largest = std::max(largest, points);
    }
    return largest;
  }
};

// Sizes: VIII had 11.1 to 38.0 % of 107 livers, and no segment was larger in the median (Mise et
// al. 2014, doi:10.1111/hpb.12157). The other bounds are wider than what surgeons call unusual.
inline void checkPlausible(const Anatomy& anatomy, const TriangleMesh& liver) {
  const auto found = LiverSegments::find(anatomy);
  REQUIRE(found);
  const SegmentGrid grid(*found, liver);
  std::array<double, kLiverSegments + 1> points{};
  std::array<Vec3, kLiverSegments + 1> sums;
  sums.fill(Vec3::Zero());
  double all = 0;
  for (std::size_t i = 0; i < grid.segments.size(); ++i) {
    const std::size_t s = std::size_t(grid.segments[i]);
    if (s > 0) ++all, ++points[s], sums[s] += grid.place(i);
  }
  for (int s = 1; s <= kLiverSegments; ++s) {
    CAPTURE(s);
    const double own = points[std::size_t(s)];
    CHECK(own > (s == 1 ? 0.02 : 0.04) * all);
    CHECK(own < (s == 1 ? 0.06 : s == 8 ? 0.35 : 0.22) * all);
    CHECK(double(grid.largestPart(s)) > 0.95 * own);
  }
  const auto middle = [&](std::initializer_list<int> some) {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (const int s : some) sum += sums[std::size_t(s)], count += points[std::size_t(s)];
    return Vec3(sum / count);
  };
  // Two centimetres: a quarter of the width of a section.
  CHECK(middle({2, 3}).x() > middle({4}).x() + 0.02);
  CHECK(middle({4}).x() > middle({5, 8}).x() + 0.02);
  CHECK(middle({2, 3, 4}).x() > middle({6, 7}).x() + 0.02);
  CHECK(middle({5, 8}).z() > middle({6, 7}).z() + 0.02);
  CHECK(middle({7}).y() > middle({6}).y() + 0.02);
  CHECK(middle({8}).y() > middle({5}).y() + 0.02);
  CHECK(middle({2}).y() > middle({3}).y() + 0.015);

  std::set<std::string> names;
  for (std::size_t i = 0; i < anatomy.segments.size(); ++i)
    names.insert(found->nameOf(anatomy, std::int32_t(i)));
  for (int s = 1; s <= kLiverSegments; ++s)
    for (const char* kind : {"portal branch", "artery", "bile duct"}) {
      const std::string name = fmt::format("{} of segment {}", kind, romanNumber(s));
      CAPTURE(name);
      CHECK(names.contains(name));
    }
}

}  // namespace resect::test

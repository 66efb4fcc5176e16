#include "operation/way/organ_section.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"

namespace resect {
namespace {

constexpr int kPlaces = 32;  // from back to front, at which the height is measured

}  // namespace

OrganSection::OrganSection(const TriangleMesh& surface, double x) {
  const auto above = [&](std::int32_t i) { return surface.points[std::size_t(i)].x() >= x; };
  for (const Triangle& t : surface.triangles) {
    if (above(t[0]) == above(t[1]) && above(t[1]) == above(t[2])) continue;
    Line line{};
    int ends = 0;
    for (int k = 0; k < 3; ++k) {
      // From the lower index to the higher: both triangles of an edge get the same bits.
      const auto [i, j] = std::minmax(t[std::size_t(k)], t[std::size_t((k + 1) % 3)]);
      if (above(i) == above(j)) continue;
      const Vec3& a = surface.points[std::size_t(i)];
      const Vec3& b = surface.points[std::size_t(j)];
      const double share = (x - a.x()) / (b.x() - a.x());
      line.z[ends] = a.z() + share * (b.z() - a.z());
      line.y[ends] = a.y() + share * (b.y() - a.y());
      ++ends;
    }
    if (line.z[0] > line.z[1]) std::swap(line.z[0], line.z[1]), std::swap(line.y[0], line.y[1]);
    lines_.push_back(line);
  }
  std::ranges::sort(lines_, {}, [](const Line& line) { return line.z[0]; });
  double begin = 0, end = -std::numeric_limits<double>::infinity();  // of the current stretch
  for (const Line& line : lines_) {
    if (line.z[0] > end) begin = line.z[0];
    end = std::max(end, line.z[1]);
    if (end - begin > front_ - back_ || &line == &lines_.front()) back_ = begin, front_ = end;
  }
  if (empty()) return;
  lowest_ = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kPlaces; ++i) {
    const Heights here = heightsAt(back_ + (front_ - back_) * i / kPlaces);
    lowest_ = std::min(lowest_, here.bottom);
    tallest_ = std::max(tallest_, here.top - here.bottom);
  }
}

double OrganSection::topAt(double z) const {
  require(!empty(), "the plane does not meet the organ; give one through its box");
  return heightsAt(z).top;
}

OrganSection::Heights OrganSection::heightsAt(double z) const {
  double nearest = lines_.front().z[0];
  for (const Line& line : lines_) {
    const double here = std::clamp(z, line.z[0], line.z[1]);
    if (std::abs(here - z) < std::abs(nearest - z)) nearest = here;
  }
  Heights heights{-std::numeric_limits<double>::infinity(),
                  std::numeric_limits<double>::infinity()};
  for (const Line& line : lines_) {
    if (nearest < line.z[0] || nearest > line.z[1]) continue;
    const double length = line.z[1] - line.z[0];
    const double share = length > 0 ? (nearest - line.z[0]) / length : 0;
    const double y = line.y[0] + share * (line.y[1] - line.y[0]);
    heights.top = std::max(heights.top, y);
    heights.bottom = std::min(heights.bottom, y);
  }
  return heights;
}

}  // namespace resect

#include "anatomy/measure_anatomy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "anatomy/vessel_index.h"
#include "collision/signed_distance.h"

namespace resect {
namespace {

constexpr double kGrid = 0.0025;        // m: of the organ's distances
constexpr double kLook = 0.0005;        // m: steps along a vessel
constexpr double kFarthestGap = 0.005;  // m: gaps beyond are not looked at

// Order of each segment: a leaf has 1; where two of the same order meet, the order grows by one.
std::vector<int> strahlerOrders(const Anatomy& anatomy) {
  std::vector<int> order(anatomy.segments.size(), 1), most(order.size(), 0), count(order.size(), 0);
  for (std::size_t i = order.size(); i-- > 0;) {
    if (most[i] > 0) order[i] = most[i] + (count[i] >= 2 ? 1 : 0);
    const std::int32_t parent = anatomy.segments[i].parent;
    if (parent < 0) continue;
    int &m = most[std::size_t(parent)], &n = count[std::size_t(parent)];
    if (order[i] > m)
      m = order[i], n = 1;
    else if (order[i] == m)
      ++n;
  }
  return order;
}

// Calls a function with each point of a regular grid that lies inside the surface.
template <class Function>
void forPointsInside(const TriangleMesh& surface, const Function& function) {
  const SignedDistance distance(surface, 0.01, kGrid);
  const Aabb box = bounds(surface);
  const Vec3i count = (box.size() / kGrid).array().ceil().cast<int>();
  for (int z = 0; z < count.z(); ++z)
    for (int y = 0; y < count.y(); ++y)
      for (int x = 0; x < count.x(); ++x) {
        const Vec3 place = box.min + kGrid * (Vec3(x, y, z) + Vec3::Constant(0.5));
        if (distance(place).distance < 0) function(place);
      }
}

}  // namespace

AnatomyMeasures measure(const Anatomy& anatomy, const TriangleMesh& surface) {
  AnatomyMeasures all;
  const SignedDistance distance(surface, 0.01, kGrid);
  const std::vector<int> orders = strahlerOrders(anatomy);
  std::array<std::vector<int>, kVesselKinds> counts;
  std::vector<std::uint8_t> inside(anatomy.segments.size());  // 0: of a stem, up to where it enters
  for (std::size_t i = 0; i < anatomy.segments.size(); ++i) {
    const VesselSegment& s = anatomy.segments[i];
    VesselMeasures& m = all.kinds[std::size_t(s.kind)];
    ++m.segments;
    m.terminals += s.leaf;
    m.length += s.length();
    m.volume += std::numbers::pi * s.radius * s.radius * s.length();
    auto& count = counts[std::size_t(s.kind)];
    const std::size_t order = std::size_t(orders[i]) - 1;
    if (m.radiusByOrder.size() <= order) m.radiusByOrder.resize(order + 1), count.resize(order + 1);
    m.radiusByOrder[order] += s.radius;
    ++count[order];
    inside[i] =
        (s.parent >= 0 && inside[std::size_t(s.parent)]) || distance(s.end).distance <= -s.radius;
    if (s.parent < 0 || !inside[std::size_t(s.parent)]) continue;
    const int steps = 1 + int(s.length() / kLook);
    for (int k = 0; k < steps; ++k)
      if (distance(s.at((k + 0.5) / steps)).distance > -s.radius) m.outside += s.length() / steps;
  }
  for (int k = 0; k < kVesselKinds; ++k)
    for (std::size_t o = 0; o < all.kinds[std::size_t(k)].radiusByOrder.size(); ++o)
      all.kinds[std::size_t(k)].radiusByOrder[o] /= counts[std::size_t(k)][o];

  for (auto& row : all.gaps) row.fill(kFarthestGap);
  const VesselIndex index(anatomy.segments);
  std::vector<std::int32_t> near;
  for (std::size_t i = 0; i < anatomy.segments.size(); ++i) {
    const VesselSegment& s = anatomy.segments[i];
    if (!inside[i]) continue;
    Aabb box;
    box.grow(s.start);
    box.grow(s.end);
    index.near(box.padded(s.radius + kFarthestGap), near);
    for (const std::int32_t j : near) {
      const VesselSegment& o = anatomy.segments[std::size_t(j)];
      if (j <= std::int32_t(i) || o.kind == s.kind || !inside[std::size_t(j)]) continue;
      const double gap = segmentDistance(s.start, s.end, o.start, o.end) - s.radius - o.radius;
      const std::size_t a = std::size_t(s.kind), b = std::size_t(o.kind);
      all.gaps[a][b] = all.gaps[b][a] = std::min(all.gaps[a][b], gap);
      if (gap < 0) ++all.crossings[a][b], all.crossings[b][a] = all.crossings[a][b];
    }
  }
  return all;
}

TerminalDistance terminalDistance(const Anatomy& anatomy, const TriangleMesh& surface) {
  std::vector<Vec3> ends;
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  for (std::int32_t i = portal.first; i < portal.first + portal.count; ++i)
    if (anatomy.segments[std::size_t(i)].leaf) ends.push_back(anatomy.segments[std::size_t(i)].end);
  TerminalDistance found;
  if (ends.empty()) return found;
  double sum = 0;
  std::int64_t count = 0;
  forPointsInside(surface, [&](const Vec3& place) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& end : ends) least = std::min(least, (end - place).squaredNorm());
    const double distance = std::sqrt(least);
    found.largest = std::max(found.largest, distance);
    sum += distance, ++count;
  });
  if (count > 0) found.mean = sum / double(count);
  return found;
}

std::array<double, kLiverSegments> segmentVolumes(const LiverSegments& segments,
                                                  const TriangleMesh& surface) {
  std::array<double, kLiverSegments> volumes{};
  forPointsInside(surface, [&](const Vec3& place) {
    volumes[std::size_t(segments.at(place) - 1)] += kGrid * kGrid * kGrid;
  });
  return volumes;
}

std::vector<NamedVessel> namedVessels(const Anatomy& anatomy, const LiverSegments& segments,
                                      std::int32_t terminals) {
  const std::vector<std::int32_t> count = terminalsOf(anatomy);
  std::vector<NamedVessel> found;
  std::vector<std::string> names;
  std::map<std::string, std::int32_t> largest;  // terminals of the largest vessel of each name
  for (std::size_t i = 0; i < count.size(); ++i) {
    const VesselSegment& s = anatomy.segments[i];
    names.push_back(segments.nameOf(anatomy, std::int32_t(i)));
    if (s.parent >= 0 && names[std::size_t(s.parent)] == names[i]) continue;
    found.push_back({names[i], s.kind, std::int32_t(i), s.radius, count[i]});
    std::int32_t& most = largest[names[i]];
    most = std::max(most, count[i]);
  }
  std::erase_if(found, [&](const NamedVessel& v) {
    return v.terminals < terminals && v.terminals < largest[v.name];
  });
  return found;
}

}  // namespace resect

#include "organ/picture/picture_vessels.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr double kBin = 0.005;             // m
constexpr double kHalfDiagonal = 0.00434;  // m: of a bin

}  // namespace

double wallOf(VesselKind kind, double radius) {
  constexpr double kThinnest = 0.12e-3;  // m
  switch (kind) {
    case VesselKind::PortalVein:
      return kThinnest + 0.20 * radius;
    case VesselKind::HepaticVein:
      return 0.5 * kThinnest + 0.05 * radius;
    case VesselKind::HepaticArtery:
      return kThinnest + 0.35 * radius;
    case VesselKind::BileDuct:
      return kThinnest + 0.30 * radius;
  }
  return kThinnest;
}

std::shared_ptr<const VesselPicture> pictureVessels(const Anatomy& anatomy) {
  if (anatomy.empty()) return nullptr;
  Aabb box;
  for (const VesselSegment& s : anatomy.segments) {
    Aabb own;
    own.grow(s.start);
    own.grow(s.end);
    box.grow(own.padded(s.radius + wallOf(s.kind, s.radius)));
  }
  auto picture = std::make_shared<VesselPicture>();
  picture->low = box.min.cast<float>();
  picture->bin = float(kBin);
  for (int a = 0; a < 3; ++a) picture->dims[a] = int(box.size()[a] / kBin) + 1;

  // The bins that a segment passes, wall included.
  const auto visit = [&](const VesselSegment& s, auto&& use) {
    const double reach = s.radius + wallOf(s.kind, s.radius) + kHalfDiagonal;
    Vec3i low, high;
    for (int a = 0; a < 3; ++a) {
      const auto bin = [&](double x) {
        return std::clamp(int((x - box.min[a]) / kBin), 0, picture->dims[a] - 1);
      };
      low[a] = bin(std::min(s.start[a], s.end[a]) - s.radius - wallOf(s.kind, s.radius));
      high[a] = bin(std::max(s.start[a], s.end[a]) + s.radius + wallOf(s.kind, s.radius));
    }
    const Vec3 way = s.end - s.start;
    const double square = std::max(way.squaredNorm(), 1e-18);
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) {
          const Vec3 centre = box.min + kBin * (Vec3(x, y, z) + Vec3::Constant(0.5));
          const double share = std::clamp((centre - s.start).dot(way) / square, 0.0, 1.0);
          if ((s.at(share) - centre).squaredNorm() <= reach * reach)
            use(std::size_t((z * picture->dims.y() + y) * picture->dims.x() + x));
        }
  };
  picture->bins.assign(std::size_t(picture->dims.prod()), {0, 0});
  for (const VesselSegment& s : anatomy.segments)
    visit(s, [&](std::size_t bin) { ++picture->bins[bin][1]; });
  std::size_t sum = 0;
  std::vector<std::size_t> next;
  for (auto& [first, count] : picture->bins) {
    next.push_back(sum);
    first = float(sum);
    sum += std::size_t(count);
  }
  picture->entries.resize(sum);
  for (const VesselSegment& s : anatomy.segments) {
    const Vec3f a = s.start.cast<float>(), b = s.end.cast<float>();
    visit(s, [&](std::size_t bin) {
      picture->entries[next[bin]++] = {a.x(), a.y(), a.z(), float(s.radius),
                                       b.x(), b.y(), b.z(), float(s.kind)};
    });
  }
  return picture;
}

}  // namespace resect

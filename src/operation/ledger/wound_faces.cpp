#include "operation/ledger/wound_faces.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/stop.h"
#include "organ/carving.h"

namespace resect {
namespace {

// Whether tissue was carved away that lay at the node nearest to a point one node in front of a
// face.
bool carvedBefore(const Organ& organ, const Vec3& middle, const Vec3& normal) {
  const ColourField& field = organ.field;
  if (organ.carved.empty()) return false;
  const Vec3 first = field.nodePosition(Vec3::Zero()),
             side = field.nodePosition(Vec3::Ones()) - first;
  const Vec3 at = (middle - first).cwiseQuotient(side) + normal;
  const Vec3i node = at.array().round().cast<int>();
  return capAt(organ, node) < organ.iso && field.originalNode(node) >= organ.iso;
}

// Whether tissue was removed that lay three quarters of a cell in front of a face.
bool removedBefore(const Organ& organ, const Vec3& middle, const Vec3& normal) {
  const Lattice& lattice = organ.rest.lattice;
  const Vec3 at = lattice.toCellSpace(middle) + 0.75 * normal;
  const Vec3i cell(int(std::floor(at.x() + 0.5)), int(std::floor(at.y() + 0.5)),
                   int(std::floor(at.z() + 0.5)));
  if (!lattice.contains(cell)) return false;
  const std::int64_t i = lattice.index(cell);
  return organ.rest.value[std::size_t(i)] > 0 && !(organ.field.cellValue(i) > 0);
}

// Calls visit(corners, lip, area) for each face of a brick that a cut or removed tissue has opened.
template <typename Visit>
void visitFaces(const Organ& organ, std::int64_t brick, Visit visit) {
  const std::span<const Vec3f> points = organ.surface.points();
  const bool edited = organ.field.edited(brick);
  organ.surface.visitBrick(brick, [&](const Triangle& t, bool lip) {
    if (!lip && !edited) return;
    const std::array<Vec3, 3> corners{points[std::size_t(t[0])].cast<double>(),
                                      points[std::size_t(t[1])].cast<double>(),
                                      points[std::size_t(t[2])].cast<double>()};
    const Vec3 cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double length = cross.norm();
    if (!(length > 0)) return;
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3, normal = cross / length;
    if (lip || removedBefore(organ, middle, normal) || carvedBefore(organ, middle, normal))
      visit(corners, lip, 0.5 * length);
  });
}

struct BrickOfFaces {
  std::int64_t brick;
  Vec3 middle;  // m
};

// Least distance of the faces of some bricks, which lie within `reach` of the bricks' middles. The
// bricks that can be nearest come first, so most others are never looked at.
double marginOf(const Organ& organ, const Structure& structure,
                const std::vector<BrickOfFaces>& bricks, double reach) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t b = 0; b < bricks.size(); ++b)
    order.push_back({structure.boxDistance(bricks[b].middle) - reach, b});
  std::ranges::sort(order);
  double margin = std::numeric_limits<double>::infinity();
  for (const auto& [least, b] : order) {
    if (least >= margin) break;
    if (const double far = margin + reach; structure.distance(bricks[b].middle, far) >= far)
      continue;
    visitFaces(organ, bricks[b].brick, [&](const auto& corners, bool, double) {
      for (const Vec3& corner : corners) margin = structure.distance(corner, margin);
    });
  }
  return margin;
}

}  // namespace

WoundFaces woundFaces(const Organ& organ, std::span<const Structure> structures) {
  WoundFaces faces;
  std::vector<BrickOfFaces> bricks;
  double reach = 0;
  for (std::int64_t brick = 0; brick < organ.field.brickCount(); ++brick) {
    if (!organ.field.edited(brick) && !organ.severed.near(brick)) continue;
    checkStop();
    bool any = false;
    visitFaces(organ, brick, [&](const auto&, bool lip, double area) {
      any = true;
      (lip ? faces.cut : faces.bared) += lip ? 0.5 * area : area;
    });
    if (!any || structures.empty()) continue;
    const Vec3 first = (kBrickNodes * organ.field.brick(brick)).cast<double>();
    const Vec3 low = organ.field.nodePosition(first),
               high = organ.field.nodePosition(first + Vec3::Constant(kBrickNodes));
    bricks.push_back({brick, 0.5 * (low + high)});
    reach = 0.51 * (high - low).norm();
  }
  for (const Structure& structure : structures)
    faces.margins.push_back(marginOf(organ, structure, bricks, reach));
  return faces;
}

std::vector<MarginPlace> marginPlaces(const Organ& organ, const Structure& structure,
                                      double within) {
  std::vector<MarginPlace> places;
  for (std::int64_t brick = 0; brick < organ.field.brickCount(); ++brick) {
    if (!organ.field.edited(brick) && !organ.severed.near(brick)) continue;
    checkStop();
    visitFaces(organ, brick, [&](const auto& corners, bool, double) {
      const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
      if (structure.boxDistance(middle) > within) return;
      const double distance = structure.distance(middle, within);
      if (distance < within) places.push_back({middle, distance});
    });
  }
  return places;
}

}  // namespace resect

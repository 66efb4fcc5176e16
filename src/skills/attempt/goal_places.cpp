#include "skills/attempt/goal_places.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "organ/region_placer.h"

namespace resect {
namespace {

// The point of a triangle that is nearest to p (Ericson 2005, section 5.1.5).
Vec3 nearestOf(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp);
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

struct SurfacePlace {
  Vec3 place, normal;
};

SurfacePlace nearestOn(const TriangleMesh& mesh, const Vec3& p) {
  SurfacePlace best{p, Vec3::UnitY()};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.points[std::size_t(t[0])].cast<double>();
    const Vec3 b = mesh.points[std::size_t(t[1])].cast<double>();
    const Vec3 c = mesh.points[std::size_t(t[2])].cast<double>();
    const Vec3 normal = (b - a).cross(c - a);
    if (!(normal.norm() > 1e-15)) continue;
    const Vec3 near = nearestOf(p, a, b, c);
    const double d = (near - p).squaredNorm();
    if (d < least) least = d, best = {near, normal.normalized()};
  }
  return best;
}

TissuePoint carried(const Vec3& rest, const Vec3& normal, const Organ& organ) {
  TissuePoint point{rest, normal, -1};
  const Lattice& lattice = organ.rest.lattice;
  double least = std::numeric_limits<double>::infinity();
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell) {
    if (!organ.rest.inside[std::size_t(cell)]) continue;
    const double d = (lattice.centre(lattice.cell(cell)) - rest).squaredNorm();
    if (d < least) least = d, point.cell = cell;
  }
  return point;
}

}  // namespace

TissuePoint tissuePoint(const Vec3& rest, const Organ& organ) {
  return carried(rest, nearestOn(organ.surface.mesh(), rest).normal, organ);
}

std::vector<TissuePoint> goalPlaces(const std::vector<TaskPlace>& places, const Organ& organ) {
  std::vector<TissuePoint> points;
  if (places.empty()) return points;
  const Aabb box = particleBox(organ.rest);
  const TriangleMesh skin = organ.surface.mesh();
  for (const TaskPlace& place : places) {
    Vec3 p = place.inWorld ? place.place : pointInBox(box, place.place);
    if (!place.landmark.empty()) {
      const auto mark = landmarkPlace(organ.rest.landmarks, place.landmark);
      if (!mark)
        throw error("the task names the landmark \"{}\", which the organ lacks; name another one",
                    place.landmark);
      p = pointInBox(box, *mark);
    }
    const SurfacePlace on = nearestOn(skin, p);
    if (place.depth) p = on.place - *place.depth * on.normal;
    points.push_back(carried(p, on.normal, organ));
  }
  return points;
}

TissuePoint presentPoint(const TissuePoint& point, const OperatedOrgan& organ) {
  if (point.cell < 0 || !organ.tissue->solid(point.cell)) return point;
  const Lattice& lattice = organ.organ.rest.lattice;
  const Vec3 centre = lattice.centre(lattice.cell(point.cell));
  const Mat3 f = organ.tissue->deformation(point.cell);
  TissuePoint now = point;
  now.rest = centre + organ.tissue->displacement(point.cell) + f * (point.rest - centre);
  const Vec3 normal = f * point.normal;
  if (normal.norm() > 1e-9) now.normal = normal.normalized();
  return now;
}

std::optional<VesselPlace> vesselNear(const Organ& organ, const Vec3& rest) {
  constexpr double kThinnest = 0.002, kFarthest = 0.03;  // m
  std::optional<VesselPlace> best;
  double least = kFarthest;
  if (!organ.map) return best;
  for (const VesselSegment& segment : organ.map->anatomy.segments) {
    const Vec3 middle = segment.at(0.5);
    const double distance = (middle - rest).norm();
    if (2 * segment.radius < kThinnest || distance >= least) continue;
    least = distance;
    best = VesselPlace{middle, segment.kind, 2 * segment.radius};
  }
  return best;
}

int labelNamed(const Organ& organ, const std::string& name) {
  const auto at = std::ranges::find(organ.rest.labelNames, name);
  return at == organ.rest.labelNames.end() ? 0 : int(at - organ.rest.labelNames.begin());
}

void requireFits(const TaskGoal& goal, const OperatedOrgan& organ) {
  using enum TaskGoal::Kind;
  if (goal.kind == Resect && labelNamed(organ.organ, goal.structure) == 0)
    throw error(
        "the task resects the structure \"{}\", which the organ \"{}\" lacks; mark it by "
        "[[organ.label]]",
        goal.structure, organ.name);
  if ((goal.kind == Divide || goal.kind == StopBleeding) && !organ.organ.map)
    throw error(
        "the task is \"{}\", and the organ \"{}\" has no vessels; give it vessels, such as "
        "vessels = \"built-in\"",
        wordOf(goal.kind), organ.name);
  for (const TaskPlace& place : goal.places)
    if (!place.landmark.empty() && !landmarkPlace(organ.organ.rest.landmarks, place.landmark))
      throw error("the task names the landmark \"{}\", which the organ \"{}\" lacks",
                  place.landmark, organ.name);
}

}  // namespace resect

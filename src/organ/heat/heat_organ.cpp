#include "organ/heat/heat_organ.h"

#include <algorithm>
#include <vector>

namespace resect {
namespace {

constexpr double kBareVessel = 0.0015;  // m: tissue round a bare vessel that is heated with it
constexpr double kHot = 45;  // C: cooler tissue does not coagulate in an operation's time

bool onBareVessel(const Organ& organ, const Vec3& place) {
  return std::ranges::any_of(organ.vessels.bared, [&](std::int32_t i) {
    const VesselSegment& s = organ.map->anatomy.segments[std::size_t(i)];
    const Vec3 way = s.end - s.start;
    const double share = std::clamp((place - s.start).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (s.at(share) - place).norm() <= s.radius + kBareVessel;
  });
}

// The mean over a cell.
double coagulatedShare(const Organ& organ, std::int64_t cell) {
  const Lattice& lattice = organ.rest.lattice;
  const Vec3 centre = lattice.centre(lattice.cell(cell));
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 off;
    for (int a = 0; a < 3; ++a) off[a] = (corner >> a & 1 ? 0.25 : -0.25) * lattice.spacing[a];
    sum += organ.heat.coagulated(centre + off);
  }
  return sum / 8;
}

void stiffen(OperatedOrgan& to) {
  constexpr double kHalf = 0.5;
  Organ& organ = to.organ;
  const Lattice& heat = organ.heat.lattice();
  std::vector<std::int64_t> cells;
  for (const HeatedSpot& s : organ.heat.spots()) {
    if (s.coagulated < kHalf) continue;
    const auto at = organ.rest.lattice.cellAt(heat.centre(heat.cell(s.index)));
    if (!at) continue;
    const std::int64_t cell = organ.rest.lattice.index(*at);
    if (organ.alive[std::size_t(cell)] && !organ.fields.coagulated[cell]) cells.push_back(cell);
  }
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  bool any = false;
  for (const std::int64_t cell : cells) {
    if (coagulatedShare(organ, cell) < kHalf) continue;
    organ.fields.coagulated.set(organ.rest.lattice, cell, 1);
    if (const TissueMaterial* material = to.tissue->material(cell)) {
      to.tissue->setMaterial(cell, coagulated(*material));
      any = true;
    }
  }
  if (any) to.tissue->settle();
}

}  // namespace

TissueMaterial coagulated(const TissueMaterial& material) {
  TissueMaterial result = material;
  result.name += ", coagulated";
  result.young *= 2;
  result.cutEnergy *= 1.5;
  result.tearEnergy *= 0.5;
  return result;
}

// Skin cells have tissue as long as the particle that they belong to.
bool isTissue(const Organ& organ, const Vec3& place) {
  const auto at = organ.rest.lattice.cellAt(place);
  if (!at) return false;
  const std::int64_t cell = organ.rest.lattice.index(*at);
  if (organ.alive[std::size_t(cell)]) return true;
  if (organ.rest.value[std::size_t(cell)] > 0 &&
      organ.alive[std::size_t(ownerCell(organ.rest, cell))])
    return true;
  return onBareVessel(organ, place);
}

double coagulatedAt(const Organ& organ, const Vec3& place) {
  if (organ.heat.empty()) return 0;
  return organ.heat.coagulatedTissue(place, [&](const Vec3& at) { return isTissue(organ, at); });
}

void heatOrgan(OperatedOrgan& organ, std::span<const HeatSource> sources, double duration,
               bool removed) {
  Organ& o = organ.organ;
  const auto tissue = [&](const Vec3& place) { return isTissue(o, place); };
  if (removed) o.heat.keepIn(tissue);
  o.heat.step(sources, duration, tissue);
  if (!o.heat.changed()) return;
  if (o.map) {
    const Lattice& heat = o.heat.lattice();
    Aabb hot;
    for (const HeatedSpot& s : o.heat.spots())
      if (s.temperature > kHot) hot.grow(heat.centre(heat.cell(s.index)));
    sealVessels(
        o.map->anatomy, o.map->index, hot,
        [&](const Vec3& place) { return coagulatedAt(o, place); }, o.vessels);
  }
  stiffen(organ);
}

}  // namespace resect

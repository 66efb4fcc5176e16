#include "tools/contacts.h"

#include <algorithm>
#include <cmath>

#include "collision/columns.h"
#include "collision/inside.h"
#include "geometry/moved_box.h"

namespace resect {
namespace {

// The stretch of the line p + t d, t in [t0, t1], inside the box; false when there is none.
bool clip(const Aabb& box, const Vec3& p, const Vec3& d, double& t0, double& t1) {
  for (int a = 0; a < 3; ++a) {
    if (std::abs(d[a]) < 1e-30) {
      if (p[a] < box.min[a] || p[a] > box.max[a]) return false;
      continue;
    }
    double enter = (box.min[a] - p[a]) / d[a], leave = (box.max[a] - p[a]) / d[a];
    if (enter > leave) std::swap(enter, leave);
    t0 = std::max(t0, enter);
    t1 = std::min(t1, leave);
  }
  return t0 <= t1;
}

// The box of the moving tool, in its own frame at `to`: it holds every place that the tool passes
// through.
Aabb sweptBox(const Aabb& tool, const Pose& from, const Pose& to) {
  // A corner strays from the chord of its arc by less than the sagitta of the rotation about the
  // tool's origin.
  const double half = 0.5 * from.rotation.angularDistance(to.rotation);
  const double reach = std::max(tool.min.norm(), tool.max.norm()) + tool.size().norm();
  const Pose back = to.inverse();
  Aabb box = tool;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? tool.max.x() : tool.min.x(), corner & 2 ? tool.max.y() : tool.min.y(),
                 corner & 4 ? tool.max.z() : tool.min.z());
    box.grow(back * (from * p));
  }
  return box.padded(reach * (1 - std::cos(std::min(half, 3.2))) + 1e-9);
}

// Layered depth images of both along z; the organ's only in the pixels that the tool covers.
double overlapVolume(const Organ& organ, const TriangleMesh& tool, const Pose& pose,
                     const Aabb& region) {
  constexpr int kPixels = 32;
  const TriangleMesh inWorld = transformed(tool, pose);
  const Aabb box = intersection(bounds(inWorld), region);
  if (box.empty() || !(box.size().array() > 0).all()) return 0;
  const Vec2 size = box.size().head<2>();
  const auto pixels = [&](double side) {
    return std::clamp(int(std::lround(kPixels * side / size.maxCoeff())), 1, kPixels);
  };
  ColumnGrid grid;
  grid.countX = pixels(size.x());
  grid.countY = pixels(size.y());
  grid.pitch = size.cwiseQuotient(Vec2(grid.countX, grid.countY));
  grid.origin = box.min.head<2>() + 0.5 * grid.pitch;

  const Crossings toolColumns = castColumns(snapToRaster(inWorld), grid);
  std::vector<std::uint8_t> covered(grid.count());
  for (std::size_t c = 0; c < covered.size(); ++c) covered[c] = !toolColumns[c].empty();
  const TriangleMesh skin = organ.surface.meshOver(organ.field, grid, covered);
  const Crossings organColumns = castColumns(snapToRaster(skin), grid);

  double length = 0;
  for (std::size_t c = 0; c < covered.size(); ++c)
    if (covered[c])
      forEachInside(toolColumns[c], [&](double entered, double left) {
        const double low = std::max(entered, box.min.z()), high = std::min(left, box.max.z());
        forEachInside(organColumns[c], [&](double from, double to) {
          length += std::max(0.0, std::min(to, high) - std::max(from, low));
        });
      });
  return length * grid.pitch.prod();
}

// Living particles in the box of the tool's frame at `to`, where they are now, ascending.
struct NearCells {
  std::vector<std::int64_t> cells;
  std::vector<Vec3> positions;  // world
};

// Of tissue at rest: rows of cells along x, clipped against the box.
NearCells nearAtRest(const Organ& organ, const Aabb& box, const Aabb& region, const Pose& to) {
  NearCells near;
  const Lattice& lattice = organ.rest.lattice;
  Vec3i low, high;
  for (int a = 0; a < 3; ++a) {
    low[a] = std::max(0, int(std::floor(lattice.toCellSpace(region.min)[a])));
    high[a] = std::min(lattice.dims[a] - 1, int(std::ceil(lattice.toCellSpace(region.max)[a])));
  }
  const Pose toTool = to.inverse();
  const Vec3 along = toTool.rotation * Vec3(lattice.spacing.x(), 0, 0);
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y) {
      double t0 = low.x(), t1 = high.x();
      if (!clip(box, toTool * lattice.centre({0, y, z}), along, t0, t1)) continue;
      const std::int64_t row = lattice.index({0, y, z});
      for (int x = int(std::ceil(t0 - 1e-9)); x <= int(std::floor(t1 + 1e-9)); ++x)
        if (organ.alive[std::size_t(row + x)]) {
          near.cells.push_back(row + x);
          near.positions.push_back(lattice.centre({x, y, z}));
        }
    }
  return near;
}

NearCells nearMoved(const Organ& organ, const TissueModel& tissue, const Aabb& box,
                    const Pose& to) {
  NearCells near;
  const Lattice& lattice = organ.rest.lattice;
  const Pose toTool = to.inverse();
  for (const std::int64_t c : tissue.cellsIn(movedBox(box, to))) {
    if (!organ.alive[std::size_t(c)]) continue;
    const Vec3 x = lattice.centre(lattice.cell(c)) + tissue.displacement(c);
    if (!box.contains(toTool * x)) continue;
    near.cells.push_back(c);
    near.positions.push_back(x);
  }
  return near;
}

}  // namespace

double standOff(const ToolModel& tool, double spacing) {
  return (tool.edge.empty() && tool.hook.empty() ? 0.5 : 0.1) * spacing;
}

ToolContacts findContacts(const Organ& organ, const TissueModel& tissue, const Tool& tool,
                          const Pose& from, const Pose& to) {
  ToolContacts contacts;
  const Aabb box = sweptBox(tool.bounds, from, to);
  NearCells near;
  if (tissue.moves()) {
    near = nearMoved(organ, tissue, box, to);
    for (const Vec3& x : near.positions) contacts.volumeOfInterest.grow(x);
  } else {
    contacts.volumeOfInterest = intersection(movedBox(box, to), organ.rest.lattice.box());
    if (contacts.volumeOfInterest.empty()) return contacts;
    near = nearAtRest(organ, box, contacts.volumeOfInterest, to);
  }
  if (near.cells.empty()) return contacts;
  const std::vector<std::uint8_t> touched = sweptInside(tool.model.mesh, from, to, near.positions);
  for (std::size_t i = 0; i < touched.size(); ++i)
    if (touched[i]) contacts.cells.push_back(near.cells[i]);
  if (!contacts.cells.empty() && !tissue.moves())
    contacts.overlapVolume = overlapVolume(organ, tool.model.mesh, to, contacts.volumeOfInterest);
  return contacts;
}

}  // namespace resect

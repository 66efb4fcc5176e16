#include "tools/contacts.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "collision/collider.h"
#include "collision/inside.h"
#include "geometry/moved_box.h"
#include "geometry/rotation.h"

namespace resect {
namespace {

// Clips the line p + t d, t in [t0, t1], to the box; false if nothing is left.
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

// Box of the moving tool in its own frame at `to`: contains the whole sweep.
Aabb sweptBox(const Aabb& tool, const Pose& from, const Pose& to) {
  // A corner deviates from the chord of its arc by less than the sagitta of the rotation about the
  // tool's origin.
  const double half = 0.5 * angleBetween(from.rotation, to.rotation);
  const double reach = std::max(tool.min.norm(), tool.max.norm()) + tool.size().norm();
  const Pose back = to.inverse();
  Aabb box = tool;
  for (int i = 0; i < 8; ++i) box.grow(back * (from * tool.corner(i)));
  return box.padded(reach * (1 - math::cos(std::min(half, 3.2))) + 1e-9);
}

// The three stages of collision/collider.h; the organ's image is made only in the pixels that the
// tool covers. region: where organ and tool may meet.
double overlapVolume(const Organ& organ, const TriangleMesh& tool, const Pose& pose,
                     const Aabb& region) {
  constexpr int kPixels = 32;
  const TriangleMesh inWorld = transformed(tool, pose);
  const Aabb box = intersection(bounds(inWorld), region);
  const ColumnGrid pixels = pixelsOver(box, kPixels);
  if (pixels.count() == 0) return 0;
  const LayeredDepthImage toolImage = layeredDepthImage(inWorld, box, pixels);
  const std::vector<std::uint8_t> covered = coveredPixels(toolImage);
  const TriangleMesh skin = organ.surface.meshOver(organ.field, pixels, covered);
  return volume(intersectionVolume(toolImage, layeredDepthImage(skin, box, pixels, covered)));
}

// Particles whose present positions are in the box, given in the tool's frame at `to`; ascending.
struct NearCells {
  std::vector<std::int64_t> cells;
  std::vector<Vec3> positions;  // world
};

// For tissue at rest: rows of cells along x, clipped to the box.
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

bool entersTissue(const ToolModel& tool) {
  return !tool.edge.empty() || !tool.hook.empty() || tool.jaws.opening > 0;
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

// B: a surface round the particles from nothing, beside OpenVDB on voxels as large as our cells and
// half as large. OpenVDB's function is another one (Zhu and Bridson's averaged spheres), so the
// surfaces are compared by what they enclose.

#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <openvdb/points/PointConversion.h>
#include <openvdb/points/PointRasterizeSDF.h>
#include <openvdb/tools/VolumeToMesh.h>

#include "base/parallel.h"
#include "geometry/measures.h"
#include "peers/rows.h"
#include "peers/timing.h"
#include "support/bench_organs.h"
#include "surface/surface_tracker.h"

namespace resect::bench {
namespace {

struct VdbSurface {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;

  double volume() const {
    TriangleMesh mesh;
    for (const auto& p : points) mesh.points.emplace_back(p.x(), p.y(), p.z());
    for (const auto& t : triangles) mesh.triangles.push_back({int(t[0]), int(t[1]), int(t[2])});
    for (const auto& q : quads) {
      mesh.triangles.push_back({int(q[0]), int(q[1]), int(q[2])});
      mesh.triangles.push_back({int(q[0]), int(q[2]), int(q[3])});
    }
    return std::abs(resect::volume(mesh));
  }
};

openvdb::points::PointDataGrid::Ptr pointGrid(const Discretization& cells) {
  std::vector<openvdb::Vec3d> positions;
  for (std::int64_t i = 0; i < cells.lattice.cellCount(); ++i)
    if (cells.inside[i]) {
      const Vec3 p = cells.lattice.centre(cells.lattice.cell(i));
      positions.emplace_back(p.x(), p.y(), p.z());
    }
  const auto transform = openvdb::math::Transform::createLinearTransform(
      2 * cells.lattice.spacing.x());  // a few points to a voxel, as its manual advises
  return openvdb::points::createPointDataGrid<openvdb::points::NullCodec,
                                              openvdb::points::PointDataGrid>(positions,
                                                                              *transform);
}

VdbSurface rasterize(const openvdb::points::PointDataGrid& points, double spacing, int refine) {
  // Spheres that reach half a cell beyond the outermost centres, averaged over our kernel's
  // support.
  const auto transform = openvdb::math::Transform::createLinearTransform(spacing / refine);
  const openvdb::GridBase::Ptr grid = openvdb::points::rasterizeSmoothSpheres(
      points, spacing, 2 * spacing, openvdb::LEVEL_SET_HALF_WIDTH, transform);
  VdbSurface surface;
  openvdb::tools::volumeToMesh(*openvdb::gridPtrCast<openvdb::FloatGrid>(grid), surface.points,
                               surface.triangles, surface.quads);
  return surface;
}

}  // namespace

Findings rebuildAgainstOpenVdb(const Effort& effort) {
  openvdb::initialize();
  struct Case {
    double particles, goal;
    int refine;
  };
  std::vector<Case> cases = {{1e4, 0, 1}, {1e5, 25, 1}, {1e5, 0, 2}};
  if (!effort.quick) cases.insert(cases.end(), {{1e6, 25, 1}, {1e6, 0, 2}});
  Findings findings;
  for (const Case& c : cases) {
    const Discretization cells = liverCells(c.particles);
    const double spacing = cells.lattice.spacing.x();
    const auto points = pointGrid(cells);
    for (const int threads : threadCounts()) {
      const ThreadLimit limit(threads);
      Comparison line;
      line.row = "B";
      line.work = fmt::format("surface from nothing, nodes s{} apart", c.refine == 1 ? "" : "/2");
      line.peer = fmt::format("OpenVDB {} rasterizeSmoothSpheres + volumeToMesh",
                              openvdb::getLibraryAbiVersionString());
      line.size = double(cells.particleCount());
      line.sizeUnit = "particles";
      line.threads = threads;
      line.goal = c.goal;
      VdbSurface theirs;
      double ours = 0;
      timeBoth([&] { buildFieldAndSurface(cells, c.refine, 50); },
               [&] { theirs = rasterize(*points, spacing, c.refine); }, effort, line);
      const SurfaceTracker surface = buildFieldAndSurface(cells, c.refine, 50).surface;
      ours = volume(surface.mesh());
      line.agreement = fmt::format("another function: encloses {:+.1f} %, {} and {} triangles",
                                   100 * (theirs.volume() / ours - 1), surface.triangleCount(),
                                   theirs.triangles.size() + 2 * theirs.quads.size());
      findings.comparisons.push_back(std::move(line));
    }
  }
  return findings;
}

}  // namespace resect::bench

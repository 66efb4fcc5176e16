// A: field and surface from nothing, beside VTK on the same nodes.

#include <fmt/format.h>
#include <vtkVersion.h>

#include "base/parallel.h"
#include "peers/rows.h"
#include "peers/timing.h"
#include "peers/vtk/vtk_field.h"
#include "peers/vtk/vtk_threads.h"
#include "support/bench_organs.h"
#include "surface/surface_tracker.h"

namespace resect::bench {

Findings rebuildAgainstVtk(const Effort& effort) {
  struct Case {
    double particles;
    int refine;
    double goal;
  };
  std::vector<Case> cases = {{1e4, 1, 200}, {1e5, 1, 200}, {1e4, 2, 0}, {1e5, 2, 0}};
  if (!effort.quick) cases.insert(cases.end(), {{1e6, 1, 400}, {1e6, 2, 1000}});
  Findings findings;
  for (const Case& c : cases) {
    const Discretization cells = liverCells(c.particles);
    const ColourField field(cells, c.refine);
    VtkField vtk(cells, field);
    vtk.recompute();
    const FieldAndSurface built = buildFieldAndSurface(cells, c.refine, 50);
    const double difference = vtk.difference(built.field);
    const std::int64_t triangles = built.surface.triangleCount();
    for (const int threads : threadCounts()) {
      const ThreadLimit limit(threads);
      setVtkThreads(threads);
      Comparison line;
      line.row = "A";
      const std::string nodes =
          fmt::format("nodes s{} apart", c.refine == 1 ? "" : fmt::format("/{}", c.refine));
      line.work = "field and surface from nothing, " + nodes;
      line.peer =
          fmt::format("VTK {} vtkSPHInterpolator + vtkFlyingEdges3D", vtkVersion::GetVTKVersion());
      line.size = double(cells.particleCount());
      line.sizeUnit = "particles";
      line.threads = threads;
      line.goal = c.goal;
      line.agrees = difference < 1e-4 && triangles == vtk.triangles();
      line.agreement = fmt::format(
          "field to {:.0e}; {} and {} triangles; {} of {} nodes evaluated", difference, triangles,
          vtk.triangles(), std::int64_t(field.slotCount()) * kBrickSize, field.nodeDims().prod());
      timeBoth([&] { buildFieldAndSurface(cells, c.refine, 50); }, [&] { vtk.recompute(); }, effort,
               line);
      findings.comparisons.push_back(line);
      if (threads == 1) {
        line.work = "field, surface and normals, " + nodes;
        line.goal = 0;
        timeBoth(
            [&] {
              auto [fresh, surface] = buildFieldAndSurface(cells, c.refine, 50);
              surface.updateLook(fresh);
            },
            [&] { vtk.recompute(true); }, effort, line);
        findings.comparisons.push_back(line);
      }
    }
  }
  return findings;
}

}  // namespace resect::bench

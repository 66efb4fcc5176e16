// E: beside vtkPolyDataToImageStencil. Its stencil is what is timed, not the flags made of it.

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkImageStencilData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataToImageStencil.h>
#include <vtkVersion.h>

#include "peers/sampling.h"

namespace resect::bench {

Findings samplingAgainstVtk(const Effort& effort) {
  vtkNew<vtkPolyData> surface;
  InsideGrid grid;
  vtkSmartPointer<vtkImageStencilData> stencil;
  SamplingPeer vtk;
  vtk.name = fmt::format("VTK {} vtkPolyDataToImageStencil", vtkVersion::GetVTKVersion());
  vtk.tolerance = 2e-6;  // its stencil rounds to a thousandth of a voxel
  vtk.prepare = [&](const TriangleMesh& mesh, const InsideGrid& g, int) {
    grid = g;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& p : mesh.points) points->InsertNextPoint(p.data());
    vtkNew<vtkCellArray> triangles;
    for (const Triangle& t : mesh.triangles) {
      const vtkIdType corners[3] = {t[0], t[1], t[2]};
      triangles->InsertNextCell(3, corners);
    }
    surface->SetPoints(points);
    surface->SetPolys(triangles);
  };
  vtk.sample = [&] {
    vtkNew<vtkPolyDataToImageStencil> filter;
    filter->SetInputData(surface);
    filter->SetOutputOrigin(grid.first.data());
    filter->SetOutputSpacing(grid.pitch.data());
    filter->SetOutputWholeExtent(0, grid.n - 1, 0, grid.n - 1, 0, grid.n - 1);
    filter->SetTolerance(0);
    filter->Update();
    stencil = filter->GetOutput();
  };
  vtk.flags = [&] {
    std::vector<std::uint8_t> flags(std::size_t(grid.n) * grid.n * grid.n, 0);
    for (int z = 0; z < grid.n; ++z)
      for (int y = 0; y < grid.n; ++y) {
        int first, last, iterator = 0;
        while (stencil->GetNextExtent(first, last, 0, grid.n - 1, y, z, iterator))
          for (int x = first; x <= last; ++x) flags[grid.index(x, y, z)] = 1;
      }
    return flags;
  };
  return compareSampling(effort, vtk);
}

}  // namespace resect::bench

// 09: how does a particle count at a distance? By the smoothing kernel, whose integral is 1.
//
// Given a file name it writes the kernel in two dimensions as a surface: x and y in smoothing
// lengths h, its height h^2 W. tools/make_gallery draws figure 3.1 of the original thesis from it.

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "geometry/triangle_mesh.h"
#include "io/mesh_file.h"
#include "sph/kernel.h"

using namespace resect;

// In two dimensions the same shape has another factor: its integral over the plane is
// 1199 pi / 2304 h^2.
double planeKernel(double r, double h) {
  return 2304 / (1199 * std::numbers::pi * h * h) * kernelShape(r / h);
}

// Squares over all places where the kernel is not zero, with perSide points along each side.
TriangleMesh planeKernelSurface(int perSide) {
  TriangleMesh mesh;
  const double step = 2 * kKernelSupport / (perSide - 1);
  for (int j = 0; j < perSide; ++j)
    for (int i = 0; i < perSide; ++i) {
      const double x = i * step - kKernelSupport, y = j * step - kKernelSupport;
      mesh.points.push_back({x, y, planeKernel(std::hypot(x, y), 1)});
      if (i == 0 || j == 0) continue;
      const int here = j * perSide + i, left = here - 1, below = here - perSide;
      mesh.triangles.push_back({below - 1, below, here});
      mesh.triangles.push_back({below - 1, here, left});
    }
  return mesh;
}

int main(int argc, char** argv) {
  const double h = 0.004, step = h / 4;
  for (double s = 0; s <= kKernelSupport; s += 0.5)
    fmt::print("r = {:.1f} h: {:6.4f} of the kernel in the middle\n", s,
               kernel(s * h, h) / kernel(0, h));

  // Equation 3.4 of the thesis, for particles on a lattice: their volumes times the kernel.
  double plane = 0, space = 0;
  for (int x = -10; x <= 10; ++x)
    for (int y = -10; y <= 10; ++y) {
      plane += step * step * planeKernel(step * std::hypot(x, y), h);
      for (int z = -10; z <= 10; ++z)
        space += step * step * step * kernel(step * std::hypot(x, y, z), h);
    }
  fmt::print("sums to {:.6f} in the plane and {:.6f} in space\n", plane, space);

  if (argc > 1) writeMeshFile(argv[1], planeKernelSurface(31));
  return std::abs(plane - 1) < 1e-4 && std::abs(space - 1) < 1e-4 && kernel(2.5 * h, h) == 0 ? 0
                                                                                             : 1;
}

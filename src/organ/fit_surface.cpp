#include "organ/fit_surface.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "sph/colour_field.h"
#include "sph/colour_values.h"
#include "sph/kernel.h"

namespace resect {
namespace {

constexpr int kRounds = 6;
constexpr double kPerCell = 2;  // points for every cell-sized piece of the surface
constexpr double kStride = 2;   // of the mean misfit; from 3 on it swings
constexpr float kLeast = 2 * kLevel;

// Points spread evenly over the mesh, in cell space: every triangle gets its share by area, inside
// it by the additive recurrence of the plastic number (Roberts 2018), which leaves no gaps.
std::vector<Vec3> spread(const TriangleMesh& mesh, const Lattice& lattice) {
  std::vector<Vec3> points;
  double due = 0, u = 0.5, v = 0.5;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = lattice.toCellSpace(mesh.points[t[0]]);
    const Vec3 b = lattice.toCellSpace(mesh.points[t[1]]) - a;
    const Vec3 c = lattice.toCellSpace(mesh.points[t[2]]) - a;
    for (due += 0.5 * b.cross(c).norm() * kPerCell; due >= 1; --due) {
      u = std::fmod(u + 0.7548776662466927, 1);
      v = std::fmod(v + 0.5698402909980532, 1);
      points.push_back(u + v <= 1 ? Vec3(a + u * b + v * c) : Vec3(a + (1 - u) * b + (1 - v) * c));
    }
  }
  return points;
}

// visit(cell, weight) for the cells in the kernel's reach of a point in cell space.
template <typename Visit>
void visitReach(const Lattice& lattice, const Vec3& p, Visit visit) {
  constexpr double kReach = kKernelSupport * kSmoothingPerSpacing;
  Vec3i low, high;
  for (int a = 0; a < 3; ++a) {
    low[a] = std::max(0, int(std::ceil(p[a] - kReach)));
    high[a] = std::min(lattice.dims[a] - 1, int(std::floor(p[a] + kReach)));
  }
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const double r = (p - Vec3(x, y, z)).norm();
        if (r < kReach) visit(lattice.index({x, y, z}), kernel(r, kSmoothingPerSpacing));
      }
}

}  // namespace

void fitSurface(const TriangleMesh& mesh, Discretization& cells) {
  const std::vector<Vec3> points = spread(mesh, cells.lattice);
  const auto fits = [&](float value) { return value > 0 && value < 100; };
  std::vector<float> value(cells.value.size());
  std::vector<std::uint8_t> fitted(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    value[i] = cells.value[i];
    fitted[i] = fits(value[i]);
  }
  const auto skin = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < fitted.size(); ++i) sum += fitted[i] ? value[i] : 0;
    return sum;
  };
  const double before = skin();
  std::vector<double> misfit(points.size());
  std::vector<float> change(value.size()), weight(value.size());
  for (int round = 0; round < kRounds; ++round) {
    parallelFor(points.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        double field = 0;
        visitReach(cells.lattice, points[k],
                   [&](std::int64_t cell, double w) { field += w * value[cell]; });
        misfit[k] = 50 - field;
      }
    });
    std::ranges::fill(change, 0.0f);
    std::ranges::fill(weight, 0.0f);
    for (std::size_t k = 0; k < points.size(); ++k)
      visitReach(cells.lattice, points[k], [&](std::int64_t cell, double w) {
        if (!fitted[cell]) return;
        change[cell] += float(w * misfit[k]);
        weight[cell] += float(w);
      });
    for (std::size_t i = 0; i < fitted.size(); ++i) {
      if (!(weight[i] > 0)) continue;
      // Where few points are near, their mean says little.
      const double trust = std::min(1.0, double(weight[i]) / (0.3 * kPerCell));
      const float moved = value[i] + float(kStride * trust * change[i] / weight[i]);
      value[i] = std::clamp(moved, kLeast, 100 - kLeast);
    }
  }
  for (std::size_t i = 0; i < fitted.size(); ++i)
    if (fitted[i]) {
      value[i] = kLevel * std::round(value[i] / kLevel);
      cells.value.set(i, value[i]);
    }
  const double after = skin();
  if (after > 0) cells.skinScale *= before / after;
}

}  // namespace resect

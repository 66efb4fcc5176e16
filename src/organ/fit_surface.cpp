#include "organ/fit_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "sph/colour_field.h"
#include "sph/colour_values.h"
#include "sph/kernel.h"

namespace resect {
namespace {

constexpr int kRounds = 6;
constexpr double kPerCell = 2;  // points for every cell-sized piece of the surface
constexpr double kStride = 2;   // relaxation factor on the mean misfit; from 3 on it oscillates
constexpr float kLeast = 2 * kLevel;

// The cells in the kernel's reach of a block of points, with their weights: computed once, since
// every round uses them twice. Some 33 cells per point.
struct Reach {
  std::vector<std::uint32_t> end;  // per point, one past its cells
  std::vector<std::int32_t> cell;
  std::vector<double> weight;
  std::vector<double> misfit;  // per point: 50 less the field there

  // visit(point, cell, weight), points in their order
  template <typename Visit>
  void forEach(Visit visit) const {
    for (std::uint32_t point = 0, k = 0; point < end.size(); ++point)
      for (; k < end[point]; ++k) visit(point, cell[k], weight[k]);
  }
};

Reach reachOf(std::span<const Vec3> points, const Lattice& lattice) {
  constexpr double kReach = kKernelSupport * kSmoothingPerSpacing;
  constexpr std::size_t kCells = 34;  // per point, on average
  Reach reach;
  reach.end.reserve(points.size());
  reach.cell.reserve(kCells * points.size());
  reach.weight.reserve(kCells * points.size());
  for (const Vec3& p : points) {
    Vec3i low, high;
    for (int a = 0; a < 3; ++a) {
      low[a] = std::max(0, int(std::ceil(p[a] - kReach)));
      high[a] = std::min(lattice.dims[a] - 1, int(std::floor(p[a] + kReach)));
    }
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) {
          const double r = (p - Vec3(x, y, z)).norm();
          if (!(r < kReach)) continue;
          reach.cell.push_back(std::int32_t(lattice.index({x, y, z})));
          reach.weight.push_back(kernel(r, kSmoothingPerSpacing));
        }
    reach.end.push_back(std::uint32_t(reach.cell.size()));
  }
  return reach;
}

std::vector<Reach> reachesOf(std::span<const Vec3> points, const Lattice& lattice) {
  constexpr std::size_t kTogether = 256;
  std::vector<Reach> reaches((points.size() + kTogether - 1) / kTogether);
  parallelFor(reaches.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<const Vec3> rest = points.subspan(i * kTogether);
      reaches[i] = reachOf(rest.first(std::min(kTogether, rest.size())), lattice);
    }
  });
  return reaches;
}

}  // namespace

std::vector<Vec3> pointsToFit(const TriangleMesh& mesh, const Lattice& lattice) {
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

void fitSurface(const TriangleMesh& mesh, Discretization& cells) {
  requireSound(mesh);
  requireSound(cells);
  std::vector<Reach> reaches = reachesOf(pointsToFit(mesh, cells.lattice), cells.lattice);
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
  std::vector<float> change(value.size()), weight(value.size());
  for (const Reach& reach : reaches)
    reach.forEach([&](std::uint32_t, std::int32_t cell, double w) { weight[cell] += float(w); });
  for (int round = 0; round < kRounds; ++round) {
    parallelFor(reaches.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (Reach& reach : std::span(reaches).subspan(begin, end - begin)) {
        reach.misfit.assign(reach.end.size(), 0);
        reach.forEach([&](std::uint32_t point, std::int32_t cell, double w) {
          reach.misfit[point] += w * value[cell];
        });
        for (double& field : reach.misfit) field = 50 - field;
      }
    });
    std::ranges::fill(change, 0.0f);
    for (const Reach& reach : reaches)
      reach.forEach([&](std::uint32_t point, std::int32_t cell, double w) {
        change[cell] += float(w * reach.misfit[point]);
      });
    for (std::size_t i = 0; i < fitted.size(); ++i) {
      if (!fitted[i] || !(weight[i] > 0)) continue;
      // Damped where few points are near.
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

// A mesh's points on the raster of the columns. Aims at the speed at which memory gives the points.
#include <algorithm>
#include <array>

#include "base/assert.h"
#include "base/instruction_set.h"
#include "base/parallel.h"
#include "collision/columns.h"
#include "collision/footprint.h"

// Every function that gives such vectors is inlined: how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {
namespace {

typedef double Four __attribute__((vector_size(32)));
typedef std::int32_t FourInts __attribute__((vector_size(16)));

// Four points are twelve numbers in three vectors, x y z x, y z x y and z x y z. Bounds that are
// not finite when a coordinate is not.
RESECT_WIDEST Aabb boundsOf(const Vec3* points, std::size_t count) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  const double* const first = points->data();
  Four low[3], high[3];
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t lane = 0; lane < 4; ++lane) low[k][lane] = first[(4 * k + lane) % 3];
  std::copy_n(low, 3, high);
  Four known{};  // stays zero as long as all are finite
  const auto add = [&](const double* numbers) __attribute__((always_inline)) {
    for (std::size_t k = 0; k < 3; ++k) {
      Four v;
      __builtin_memcpy(&v, numbers + 4 * k, sizeof v);
      low[k] = v < low[k] ? v : low[k];
      high[k] = v > high[k] ? v : high[k];
      known += v - v;
    }
  };
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) add(points[i].data());
  std::array<Vec3, 4> rest;  // and the first ones again
  for (std::size_t k = 0; k < 4; ++k) rest[k] = points[i + k < count ? i + k : 0];
  add(rest[0].data());

  Vec3 lowest = Vec3(first), highest = lowest;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto axis = Eigen::Index((4 * k + lane) % 3);
      lowest[axis] = std::min(lowest[axis], low[k][lane]);
      highest[axis] = std::max(highest[axis], high[k][lane]);
    }
  const double unknown = (known[0] + known[1]) + (known[2] + known[3]);
  return {lowest.array() + unknown, highest.array() + unknown};
}

// lowest: x y x y.
RESECT_WIDEST void snap(const Vec3* points, std::size_t count, const Four& lowest, double step,
                        SnappedMesh::Place* to) {
  const auto placesOf = [&](const Vec3& p, const Vec3& q) __attribute__((always_inline))->FourInts {
    Four steps = (Four{p[0], p[1], q[0], q[1]} - lowest) / step + 0.5;
    // The highest point may round to one step beyond the raster; it stays on it.
    steps = steps < kRaster ? steps : Four{} + kRaster;
    return __builtin_convertvector(steps, FourInts);
  };
  std::size_t i = 0;
  for (; i + 2 <= count; i += 2) {
    const FourInts at = placesOf(points[i], points[i + 1]);
    __builtin_memcpy(to + i, &at, sizeof at);
  }
  if (i == count) return;
  const FourInts at = placesOf(points[i], points[i]);
  to[i] = {at[0], at[1]};
}

}  // namespace

SnappedMesh snapToRaster(const TriangleMesh& mesh) {
  SnappedMesh snapped;
  snapped.triangles = mesh.triangles;
  if (mesh.points.empty()) return snapped;
  snapped.box = boundsOf(mesh.points.data(), mesh.points.size());
  const Aabb& box = snapped.box;
  RESECT_ASSERT(box.min.allFinite() && box.max.allFinite());
  snapped.origin = box.min.head<2>();
  const double extent = box.size().head<2>().maxCoeff();
  if (extent > 0) snapped.step = extent / kRaster;
  snapped.points = mesh.points;
  snapped.places.resize(mesh.points.size());
  const Four lowest{box.min.x(), box.min.y(), box.min.x(), box.min.y()};
  parallelFor(mesh.points.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    snap(mesh.points.data() + begin, end - begin, lowest, snapped.step,
         snapped.places.data() + begin);
  });
  return snapped;
}

}  // namespace resect

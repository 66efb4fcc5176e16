#include "collision/wall_thickness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "collision/columns.h"
#include "geometry/measures.h"

namespace resect {
namespace {

constexpr int kPoints = 2000;

struct SurfacePlace {
  Vec3 point;
  double cosine;  // between the normal and the direction in which it looks
};

std::array<Vec3, 13> directions() {
  std::array<Vec3, 13> all;
  std::size_t count = 0;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        // One of each pair of opposite ones.
        if (z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0))))
          all[count++] = Vec3(x, y, z).normalized();
  return all;
}

// The points of each direction.
std::array<std::vector<SurfacePlace>, 13> placesOn(const TriangleMesh& mesh,
                                                   const std::array<Vec3, 13>& ways) {
  std::array<std::vector<SurfacePlace>, 13> places;
  const double each = area(mesh) / kPoints;
  double passed = 0, next = 0.5 * each;  // area
  int number = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.points[std::size_t(t[0])];
    const Vec3 ab = mesh.points[std::size_t(t[1])] - a, ac = mesh.points[std::size_t(t[2])] - a;
    const Vec3 normal = ab.cross(ac);
    const double length = normal.norm();
    passed += 0.5 * length;
    for (; next <= passed && length > 0; next += each, ++number) {
      // The additive recurrence of the plastic number (Roberts 2018) spreads points in a square;
      // one half of it is folded onto the other.
      double u = std::fmod(0.5 + 0.7548776662466927 * number, 1.0);
      double v = std::fmod(0.5 + 0.5698402909980532 * number, 1.0);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      std::size_t best = 0;
      double cosine = -1;
      for (std::size_t w = 0; w < ways.size(); ++w) {
        const double c = std::abs(ways[w].dot(normal)) / length;
        if (c > cosine) cosine = c, best = w;
      }
      places[best].push_back({a + u * ab + v * ac, cosine});
    }
  }
  return places;
}

// Share of its volume that a wall of so many cells keeps.
double keptOf(double cells) {
  constexpr std::array<std::array<double, 2>, 10> kMeasured{{{0, 0},
                                                             {0.4, 0.09},
                                                             {0.5, 0.13},
                                                             {0.6, 0.34},
                                                             {0.7, 0.64},
                                                             {0.8, 0.84},
                                                             {0.9, 0.90},
                                                             {1, 0.94},
                                                             {1.2, 0.98},
                                                             {2, 1}}};
  for (std::size_t i = 1; i < kMeasured.size(); ++i) {
    const auto [x0, y0] = kMeasured[i - 1];
    const auto [x1, y1] = kMeasured[i];
    if (cells < x1) return y0 + (y1 - y0) * (cells - x0) / (x1 - x0);
  }
  return 1;
}

}  // namespace

double WallThickness::at(double share) const {
  if (ascending.empty()) return 0;
  const auto place = std::size_t(share * double(ascending.size()));
  return ascending[std::min(place, ascending.size() - 1)];
}

double WallThickness::lostAt(double cell) const {
  double lost = 0, all = 0;
  for (const double thickness : ascending) {
    all += thickness;
    lost += thickness * (1 - keptOf(thickness / cell));
  }
  return all > 0 ? lost / all : 0;
}

double WallThickness::cellFor(double lost) const {
  constexpr double kStep = 1e-5;  // m
  int low = 0, high = int(1 / kStep);
  while (low < high) {
    const int middle = (low + high + 1) / 2;
    if (lostAt(middle * kStep) <= lost)
      low = middle;
    else
      high = middle - 1;
  }
  return low * kStep;
}

WallThickness wallThickness(const TriangleMesh& mesh) {
  const std::array<Vec3, 13> ways = directions();
  const auto places = placesOn(mesh, ways);
  WallThickness result;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    if (places[w].empty()) continue;
    // Turned so that the direction is +z.
    const Vec3 z = ways[w], x = z.unitOrthogonal(), y = z.cross(x);
    const auto turned = [&](const Vec3& p) { return Vec3(x.dot(p), y.dot(p), z.dot(p)); };
    TriangleMesh seen = mesh;
    for (Vec3& p : seen.points) p = turned(p);
    std::vector<Vec2> columns;
    for (const SurfacePlace& place : places[w]) columns.push_back(turned(place.point).head<2>());
    const Crossings crossings = castColumns(snapToRaster(seen), columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double depth = z.dot(places[w][i].point);
      double nearest = std::numeric_limits<double>::infinity(), length = 0;
      forEachInside(crossings[i], [&](double from, double to) {
        const double off = std::min(std::abs(from - depth), std::abs(to - depth));
        if (off < nearest) nearest = off, length = to - from;
      });
      if (length > 0) result.ascending.push_back(length * places[w][i].cosine);
    }
  }
  std::ranges::sort(result.ascending);
  return result;
}

}  // namespace resect

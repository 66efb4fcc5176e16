#include "isosurface/marching_cubes_table.h"

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "base/vec.h"

namespace resect {
namespace {

Vec3 cornerPosition(int corner) { return Vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1); }

int edgeBetween(int a, int b) {
  for (int e = 0; e < 12; ++e)
    if ((kCellEdges[e].from == a && kCellEdges[e].to == b) ||
        (kCellEdges[e].from == b && kCellEdges[e].to == a))
      return e;
  return -1;
}

Vec3 edgeMiddle(int e) {
  return 0.5 * (cornerPosition(kCellEdges[e].from) + cornerPosition(kCellEdges[e].to));
}

// The four corners of each face, counter-clockwise seen from outside the cell.
std::array<std::array<int, 4>, 6> cellFaces() {
  std::array<std::array<int, 4>, 6> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, w = 1 << axis;
    faces[2 * axis] = {0, v, u | v, u};
    faces[2 * axis + 1] = {w, w | u, w | u | v, w | v};
  }
  return faces;
}

// next[e]: the edge where the line that starts at edge e ends, or -1.
std::array<int, 12> fenceLines(int inside) {
  std::array<int, 12> next;
  next.fill(-1);
  const auto isIn = [&](int corner) { return (inside >> corner & 1) != 0; };
  for (const auto& ring : cellFaces())
    for (int i = 0; i < 4; ++i) {
      // A run of inside corners starts after i; walk to its end.
      if (isIn(ring[i]) || !isIn(ring[(i + 1) % 4])) continue;
      int last = i + 1;
      while (isIn(ring[(last + 1) % 4])) ++last;
      const int start = edgeBetween(ring[i], ring[(i + 1) % 4]);
      const int end = edgeBetween(ring[last % 4], ring[(last + 1) % 4]);
      next[start] = end;
    }
  return next;
}

bool onOneFace(int e, int f) {
  const Vec3 a = edgeMiddle(e), b = edgeMiddle(f);
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] == b[axis] && (a[axis] == 0 || a[axis] == 1)) return true;
  return false;
}

// Shape measure of a triangle: 1 if equilateral, larger the more slender it is.
double badness(int a, int b, int c) {
  const Vec3 p = edgeMiddle(a), q = edgeMiddle(b), r = edgeMiddle(c);
  const double area = 0.5 * (q - p).cross(r - p).norm();
  const double sides = (q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm();
  return area < 1e-9 ? 1e3 : sides / (4 * std::sqrt(3.0) * area);
}

// Triangulates the loop's corners i..j with the least total badness; diagonals in a face get a
// prohibitive penalty.
struct Triangulation {
  double cost = 0;
  std::vector<std::array<std::uint8_t, 3>> triangles;
};
Triangulation triangulate(const std::vector<int>& loop, int i, int j) {
  if (j - i < 2) return {};
  Triangulation best;
  best.cost = std::numeric_limits<double>::infinity();
  const auto diagonal = [&](int a, int b) {
    const bool side = b - a == 1 || (a == 0 && b + 1 == int(loop.size()));
    return !side && onOneFace(loop[a], loop[b]) ? 1e6 : 0.0;
  };
  for (int k = i + 1; k < j; ++k) {
    Triangulation left = triangulate(loop, i, k), right = triangulate(loop, k, j);
    const double cost = left.cost + right.cost + badness(loop[i], loop[k], loop[j]) +
                        diagonal(i, k) + diagonal(k, j);
    if (cost < best.cost - 1e-9) {
      best.cost = cost;
      best.triangles = std::move(left.triangles);
      best.triangles.insert(best.triangles.end(), right.triangles.begin(), right.triangles.end());
      best.triangles.push_back(
          {std::uint8_t(loop[i]), std::uint8_t(loop[k]), std::uint8_t(loop[j])});
    }
  }
  return best;
}

std::array<CellTriangles, 256> makeTable() {
  std::array<CellTriangles, 256> table;
  for (int inside = 0; inside < 256; ++inside) {
    std::array<int, 12> next = fenceLines(inside);
    for (int first = 0; first < 12; ++first) {
      std::vector<int> loop;
      for (int e = first; next[e] >= 0;) {
        loop.push_back(e);
        const int following = next[e];
        next[e] = -1;
        e = following;
      }
      if (loop.empty()) continue;
      for (const auto& t : triangulate(loop, 0, int(loop.size()) - 1).triangles)
        table[inside].edges[table[inside].count++] = t;
    }
  }
  return table;
}

}  // namespace

const std::array<CellTriangles, 256>& marchingCubesTable() {
  static const std::array<CellTriangles, 256> table = makeTable();
  return table;
}

}  // namespace resect

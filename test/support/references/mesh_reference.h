// Slow, obvious answers about closed meshes, to test the fast ones against.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>

#include "geometry/triangle_mesh.h"

namespace resect::test {

// Solid angle of the mesh seen from p over 4 pi (Van Oosterom, Strackee 1983): the number of shells
// round p, for any p not on the surface.
inline double solidAngleWinding(const TriangleMesh& mesh, const Vec3& p) {
  double sum = 0;
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Vec3 a = mesh.points[ia] - p, b = mesh.points[ib] - p, c = mesh.points[ic] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

// Distance of p to the triangle (Ericson 2005, by regions).
inline double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto toSegment = [&](const Vec3& u, const Vec3& v) {
    const Vec3 d = v - u;
    const double length2 = d.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - u).dot(d) / length2, 0.0, 1.0) : 0.0;
    return (p - (u + t * d)).norm();
  };
  const double edges = std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
  const Vec3 n = (b - a).cross(c - a);
  if (!(n.squaredNorm() > 0)) return edges;
  const bool over = (b - a).cross(p - a).dot(n) >= 0 && (c - b).cross(p - b).dot(n) >= 0 &&
                    (a - c).cross(p - c).dot(n) >= 0;
  return over ? std::abs((p - a).dot(n)) / n.norm() : edges;
}

inline double distanceToMesh(const TriangleMesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles)
    least = std::min(least, distanceToTriangle(p, mesh.points[a], mesh.points[b], mesh.points[c]));
  return least;
}

// The v and f lines of a plain .obj file of triangles; enough for the optional liver.
inline TriangleMesh readPlainObj(const std::string& path) {
  TriangleMesh mesh;
  std::ifstream in(path);
  for (std::string line, key; std::getline(in, line);) {
    std::istringstream words(line);
    words >> key;
    if (key == "v") {
      Vec3 p;
      words >> p.x() >> p.y() >> p.z();
      mesh.points.push_back(p);
    } else if (key == "f") {
      Triangle t;
      for (auto& corner : t) {
        std::string word;
        words >> word;
        corner = std::stoi(word) - 1;
      }
      mesh.triangles.push_back(t);
    }
  }
  return mesh;
}

}  // namespace resect::test

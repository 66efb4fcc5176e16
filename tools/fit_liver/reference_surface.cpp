#include "reference_surface.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <sstream>

#include "base/error.h"
#include "geometry/point_triangle.h"

namespace fit_liver {
namespace {

using resect::Aabb;
using resect::Triangle;
using resect::Vec3;

constexpr int kColumns = 128;
constexpr int kLeaf = 4;

double distanceToBox(const Aabb& box, const Vec3& p) {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).squaredNorm();
}

}  // namespace

resect::TriangleMesh readObj(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw resect::error("{}: cannot be opened; give the folder of the data", path);
  resect::TriangleMesh mesh;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string kind, word;
    words >> kind;
    if (kind == "v") {
      Vec3 p;
      words >> p.x() >> p.y() >> p.z();
      mesh.points.push_back(p);
    } else if (kind == "f") {
      std::vector<int> corners;
      while (words >> word) corners.push_back(std::stoi(word) - 1);
      for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  return mesh;
}

ReferenceSurface::ReferenceSurface(resect::TriangleMesh mesh)
    : mesh_(std::move(mesh)),
      order_(mesh_.triangles.size()),
      box_(resect::bounds(mesh_)),
      columns_(kColumns * kColumns) {
  std::iota(order_.begin(), order_.end(), 0);
  build(0, int(order_.size()));
  const Vec3 cell = box_.size() / kColumns;
  for (int t = 0; t < int(mesh_.triangles.size()); ++t) {
    Aabb box;
    for (int corner : mesh_.triangles[t]) box.grow(mesh_.points[corner]);
    const auto column = [&](double x, int axis) {
      return std::clamp(int((x - box_.min[axis]) / cell[axis]), 0, kColumns - 1);
    };
    for (int i = column(box.min.x(), 0); i <= column(box.max.x(), 0); ++i)
      for (int k = column(box.min.z(), 2); k <= column(box.max.z(), 2); ++k)
        columns_[i * kColumns + k].push_back(t);
  }
}

int ReferenceSurface::build(int begin, int end) {
  const int index = int(nodes_.size());
  nodes_.push_back({{}, begin, end});
  Aabb box, centres;
  const auto centre = [&](int t) -> Vec3 {
    const Triangle& c = mesh_.triangles[t];
    return (mesh_.points[c[0]] + mesh_.points[c[1]] + mesh_.points[c[2]]) / 3;
  };
  for (int i = begin; i < end; ++i) {
    for (int corner : mesh_.triangles[order_[i]]) box.grow(mesh_.points[corner]);
    centres.grow(centre(order_[i]));
  }
  nodes_[index].box = box;
  if (end - begin > kLeaf) {
    int axis;
    centres.size().maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](int a, int b) {
                       const double ca = centre(a)[axis], cb = centre(b)[axis];
                       return ca != cb ? ca < cb : a < b;
                     });
    const int left = build(begin, middle), right = build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
  }
  return index;
}

void ReferenceSurface::nearest(int index, const Vec3& p, double& best) const {
  const Node& node = nodes_[index];
  if (node.left < 0) {
    for (int i = node.begin; i < node.end; ++i) {
      const Triangle& t = mesh_.triangles[order_[i]];
      best = std::min(best, resect::squaredDistance(p, mesh_.points[t[0]], mesh_.points[t[1]],
                                                    mesh_.points[t[2]]));
    }
    return;
  }
  const double left = distanceToBox(nodes_[node.left].box, p);
  const double right = distanceToBox(nodes_[node.right].box, p);
  const bool leftFirst = left <= right;
  if ((leftFirst ? left : right) < best) nearest(leftFirst ? node.left : node.right, p, best);
  if ((leftFirst ? right : left) < best) nearest(leftFirst ? node.right : node.left, p, best);
}

bool ReferenceSurface::inside(const Vec3& p) const {
  if (!box_.contains(p)) return false;
  const Vec3 cell = box_.size() / kColumns;
  const int i = std::clamp(int((p.x() - box_.min.x()) / cell.x()), 0, kColumns - 1);
  const int k = std::clamp(int((p.z() - box_.min.z()) / cell.z()), 0, kColumns - 1);
  bool odd = false;
  for (int t : columns_[i * kColumns + k]) {
    const Triangle& c = mesh_.triangles[t];
    // Twice the signed areas seen from above: all of one sign when p's column meets the triangle.
    double area[3];
    for (int e = 0; e < 3; ++e) {
      const Vec3 a = mesh_.points[c[e]] - p, b = mesh_.points[c[(e + 1) % 3]] - p;
      area[(e + 2) % 3] = a.x() * b.z() - a.z() * b.x();
    }
    const bool up = area[0] > 0 && area[1] > 0 && area[2] > 0;
    const bool down = area[0] < 0 && area[1] < 0 && area[2] < 0;
    if (!up && !down) continue;
    double y = 0;
    for (int e = 0; e < 3; ++e) y += area[e] * mesh_.points[c[e]].y();
    odd ^= y / (area[0] + area[1] + area[2]) > p.y();
  }
  return odd;
}

double ReferenceSurface::signedDistance(const Vec3& p) const {
  double best = std::numeric_limits<double>::infinity();
  nearest(0, p, best);
  return inside(p) ? -std::sqrt(best) : std::sqrt(best);
}

}  // namespace fit_liver

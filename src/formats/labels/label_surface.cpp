#include "formats/labels/label_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/labels/slice_interpolation.h"
#include "isosurface/marching_cubes_table.h"

namespace resect {
namespace {

constexpr double kHalfVoxel = 0.5;  // the most that a point moves along an axis, voxels

// Calls visit(layer's voxel, x, y, z) for all voxels of labels whose flag is set.
template <typename Visit>
void visitChosen(const LabelImage& image, const std::vector<std::uint8_t>& flags,
                 const Visit& visit) {
  const Vec3i& n = image.dims;
  for (const RawArray<std::uint16_t>& layer : image.layers) {
    std::size_t i = 0;
    for (int z = 0; z < n.z(); ++z)
      for (int y = 0; y < n.y(); ++y)
        for (int x = 0; x < n.x(); ++x, ++i)
          if (flags[layer[i]]) visit(x, y, z);
  }
}

// The chosen voxels, cut out, with one layer of empty voxels round them.
struct CutOut {
  Vec3 first = Vec3::Zero();  // place of the mask's first voxel in the image, voxels
  Vec3 size = Vec3::Ones();   // of the mask's voxels, voxels of the image
  Mask mask;
  std::int64_t voxels = 0;  // of the image
};

CutOut cutOut(const LabelImage& image, std::span<const int> chosen) {
  std::vector<std::uint8_t> flags(image.labels.size() + 1, 0);
  for (const int label : chosen) flags[std::size_t(label) + 1] = 1;
  Vec3i low = image.dims, high = Vec3i::Constant(-1);
  visitChosen(image, flags, [&](int x, int y, int z) {
    low = low.cwiseMin(Vec3i(x, y, z));
    high = high.cwiseMax(Vec3i(x, y, z));
  });
  CutOut result;
  if (high.x() < 0) return result;
  low -= Vec3i::Ones();
  result.first = low.cast<double>();
  Mask& mask = result.mask;
  mask.dims = high - low + Vec3i::Constant(2);
  mask.inside.assign(
      std::size_t(mask.dims.x()) * std::size_t(mask.dims.y()) * std::size_t(mask.dims.z()), 0);
  visitChosen(image, flags, [&](int x, int y, int z) {
    std::uint8_t& voxel = mask.inside[mask.index(x - low.x(), y - low.y(), z - low.z())];
    result.voxels += !voxel;
    voxel = 1;
  });
  return result;
}

// Parts voxels that are longer along one axis, so that they become about as long as along the
// others.
void partThickSlices(CutOut& cut, const Vec3& spacing) {
  constexpr int kMostParts = 12;
  int axis;
  const double longest = spacing.maxCoeff(&axis);
  const int parts = std::min(kMostParts, int(std::round(longest / spacing.minCoeff())));
  if (parts < 2) return;
  cut.mask = withThinSlices(cut.mask, spacing, axis, parts);
  cut.size[axis] = 1.0 / parts;
  cut.first[axis] -= 0.5 - 0.5 / parts;
}

// Marching cubes: a point halfway between any two neighbouring voxels of which one is inside. In
// voxels of the mask.
TriangleMesh steps(const Mask& mask) {
  TriangleMesh mesh;
  const auto& table = marchingCubesTable();
  const Vec3i& n = mask.dims;
  // Points on the edges that begin in a slice of voxels, by axis; two slices at a time.
  const std::size_t slice = std::size_t(n.x()) * std::size_t(n.y());
  std::array<std::array<std::vector<std::int32_t>, 3>, 2> known;
  for (auto& axes : known)
    for (auto& points : axes) points.assign(slice, -1);
  for (int z = 0; z + 1 < n.z(); ++z) {
    for (int y = 0; y + 1 < n.y(); ++y)
      for (int x = 0; x + 1 < n.x(); ++x) {
        unsigned corners = 0;
        for (unsigned c = 0; c < 8; ++c)
          corners |=
              unsigned(
                  mask.inside[mask.index(x + int(c & 1), y + int(c >> 1 & 1), z + int(c >> 2))])
              << c;
        const CellTriangles& cell = table[corners];
        for (int t = 0; t < cell.count; ++t) {
          Triangle triangle;
          for (int i = 0; i < 3; ++i) {
            const CellEdge edge = kCellEdges[cell.edges[std::size_t(t)][std::size_t(i)]];
            const Vec3i from(x + (edge.from & 1), y + (edge.from >> 1 & 1), z + (edge.from >> 2));
            std::int32_t& point =
                known[std::size_t(from.z() & 1)][edge.axis]
                     [std::size_t(from.y()) * std::size_t(n.x()) + std::size_t(from.x())];
            if (point < 0) {
              point = std::int32_t(mesh.points.size());
              mesh.points.push_back(from.cast<double>() + kHalfVoxel * Vec3::Unit(edge.axis));
            }
            triangle[std::size_t(i)] = point;
          }
          mesh.triangles.push_back(triangle);
        }
      }
    for (auto& points : known[std::size_t(z & 1)]) std::ranges::fill(points, -1);
  }
  return mesh;
}

// The neighbours of each point.
struct Neighbours {
  std::vector<std::int32_t> first, point;  // of point i: point[first[i]] to point[first[i + 1] - 1]

  explicit Neighbours(const TriangleMesh& mesh) : first(mesh.points.size() + 1, 0) {
    for (const Triangle& t : mesh.triangles)
      for (const std::int32_t i : t) ++first[std::size_t(i) + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    point.resize(std::size_t(first.back()));
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    for (const Triangle& t : mesh.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        point[std::size_t(next[std::size_t(t[i])]++)] = t[(i + 1) % 3];
  }

  // Moves each value halfway to the mean of its neighbours, `rounds` times.
  std::vector<double> smoothed(std::vector<double> value, int rounds) const {
    std::vector<double> next(value.size());
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        double sum = 0;
        for (std::int32_t k = first[i]; k < first[i + 1]; ++k)
          sum += value[std::size_t(point[std::size_t(k)])];
        next[i] = 0.5 * value[i] + 0.5 * sum / (first[i + 1] - first[i]);
      }
      std::swap(value, next);
    }
    return value;
  }
};

// reach: how far points may move along each axis, in voxels of the mask.
void smooth(TriangleMesh& mesh, const Vec3& reach) {
  constexpr int kRounds = 16;  // after which steps of one voxel can hardly be seen
  const Neighbours neighbours(mesh);
  for (int axis = 0; axis < 3; ++axis) {
    const int rounds = int(std::round(kRounds * std::min(4.0, 2 * reach[axis])));
    std::vector<double> start;
    start.reserve(mesh.points.size());
    for (const Vec3& p : mesh.points) start.push_back(p[axis]);
    const std::vector<double> once = neighbours.smoothed(start, rounds);
    const std::vector<double> twice = neighbours.smoothed(once, rounds);
    for (std::size_t i = 0; i < start.size(); ++i)
      mesh.points[i][axis] =
          start[i] + std::clamp(2 * once[i] - twice[i] - start[i], -reach[axis], reach[axis]);
  }
}

// Moves the surface along its normals until it encloses `volume`. All in voxels. In this thread
// alone, since a child process that reads a file has no other.
void fillVolume(TriangleMesh& mesh, double volume) {
  const Vec3 tip = mesh.points[0];
  for (int round = 0; round < 3; ++round) {
    double area = 0, enclosed = 0;
    std::vector<Vec3> normal(mesh.points.size(), Vec3::Zero());
    for (const Triangle& t : mesh.triangles) {
      const Vec3 &a = mesh.points[std::size_t(t[0])], &b = mesh.points[std::size_t(t[1])],
                 &c = mesh.points[std::size_t(t[2])];
      const Vec3 twice = (b - a).cross(c - a);
      area += 0.5 * twice.norm();
      enclosed += (a - tip).dot(twice) / 6;
      for (const std::int32_t i : t) normal[std::size_t(i)] += twice;
    }
    if (!(area > 1e-6)) return;
    const double by = std::clamp((volume - enclosed) / area, -kHalfVoxel, kHalfVoxel);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      if (const double length = normal[i].norm(); length > 0)
        mesh.points[i] += by / length * normal[i];
  }
}

}  // namespace

TriangleMesh labelSurface(const LabelImage& image, std::span<const int> chosen) {
  CutOut cut = cutOut(image, chosen);
  if (cut.voxels == 0) return {};
  partThickSlices(cut, image.spacing());
  TriangleMesh mesh = steps(cut.mask);
  smooth(mesh, kHalfVoxel * cut.size.cwiseInverse());
  fillVolume(mesh, double(cut.voxels) / cut.size.prod());
  for (Vec3& p : mesh.points)
    p = image.origin + image.step * (cut.first + p.cwiseProduct(cut.size));
  if (image.step.determinant() < 0) flip(mesh);
  return mesh;
}

}  // namespace resect

#include "inventor/gl/SoMarchingCubes.h"

#include <Inventor/engines/SoSubEngine.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "isosurface/marching_cubes_table.h"

namespace resect {
namespace {

struct Grid {
  int n[3];
  const float* value;
  SbVec3f low, step;
  std::int64_t index(int x, int y, int z) const { return (std::int64_t(z) * n[1] + y) * n[0] + x; }
  float at(int x, int y, int z) const { return value[index(x, y, z)]; }
  SbVec3f place(int x, int y, int z) const {
    return SbVec3f(low[0] + float(x) * step[0], low[1] + float(y) * step[1],
                   low[2] + float(z) * step[2]);
  }
  // Central differences, one-sided on the border.
  SbVec3f gradient(int x, int y, int z) const {
    const int p[3] = {x, y, z};
    SbVec3f g;
    for (int a = 0; a < 3; ++a) {
      int before[3] = {x, y, z}, after[3] = {x, y, z};
      before[a] = std::max(0, p[a] - 1);
      after[a] = std::min(n[a] - 1, p[a] + 1);
      g[a] = (at(after[0], after[1], after[2]) - at(before[0], before[1], before[2])) /
             (float(std::max(1, after[a] - before[a])) * step[a]);
    }
    return g;
  }
};

}  // namespace

SO_ENGINE_SOURCE(SoMarchingCubes);

void SoMarchingCubes::initClass() {
  if (classTypeId != SoType::badType()) return;
  // Not SO_ENGINE_INIT_CLASS: it would keep the So in the name that files use.
  PRIVATE_COMMON_ENGINE_INIT_CODE(SoMarchingCubes, "MarchingCubes",
                                  &SoMarchingCubes::createInstance, SoEngine);
}

SoMarchingCubes::SoMarchingCubes() {
  SO_ENGINE_CONSTRUCTOR(SoMarchingCubes);
  SO_ENGINE_ADD_INPUT(dims, (0, 0, 0));
  SO_ENGINE_ADD_INPUT(value, (0));
  SO_ENGINE_ADD_INPUT(min, (0, 0, 0));
  SO_ENGINE_ADD_INPUT(max, (1, 1, 1));
  SO_ENGINE_ADD_INPUT(iso, (50));
  SO_ENGINE_ADD_OUTPUT(points, SoMFVec3f);
  SO_ENGINE_ADD_OUTPUT(normals, SoMFVec3f);
  SO_ENGINE_ADD_OUTPUT(coordIndex, SoMFInt32);
  SO_ENGINE_ADD_OUTPUT(triangleCount, SoSFInt32);
}

void SoMarchingCubes::evaluate() {
  const SbVec3s size = dims.getValue();
  std::vector<SbVec3f> vertices, directions;
  std::vector<std::int32_t> corners;
  const std::int64_t nodes = std::int64_t(std::max<int>(0, size[0])) * std::max<int>(0, size[1]) *
                             std::max<int>(0, size[2]);
  constexpr std::int64_t kMostNodes = 512LL * 512 * 512;
  if (size[0] >= 2 && size[1] >= 2 && size[2] >= 2 && nodes <= kMostNodes) {
    std::vector<float> values(std::size_t(nodes), 0.0f);
    std::copy_n(value.getValues(0), std::min<std::int64_t>(nodes, value.getNum()), values.begin());
    Grid grid{{size[0], size[1], size[2]}, values.data(), min.getValue(), {}};
    for (int a = 0; a < 3; ++a)
      grid.step[a] = (max.getValue()[a] - min.getValue()[a]) / float(size[a] - 1);
    const float level = iso.getValue();
    const auto& table = marchingCubesTable();
    // The vertex on each of a node's three edges towards higher x, y, z; -1: none yet.
    std::vector<std::array<std::int32_t, 3>> vertexOf(std::size_t(nodes), {-1, -1, -1});
    for (int z = 0; z + 1 < size[2]; ++z)
      for (int y = 0; y + 1 < size[1]; ++y)
        for (int x = 0; x + 1 < size[0]; ++x) {
          unsigned inside = 0;
          for (int c = 0; c < 8; ++c)
            inside |= unsigned(grid.at(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)) >= level) << c;
          const CellTriangles& cell = table[inside];
          for (int t = 0; t < cell.count; ++t) {
            for (const std::uint8_t e : cell.edges[t]) {
              const CellEdge& edge = kCellEdges[e];
              const int from[3] = {x + (edge.from & 1), y + (edge.from >> 1 & 1),
                                   z + (edge.from >> 2)};
              int to[3] = {from[0], from[1], from[2]};
              ++to[edge.axis];
              std::int32_t& vertex =
                  vertexOf[std::size_t(grid.index(from[0], from[1], from[2]))][edge.axis];
              if (vertex < 0) {
                const float a = grid.at(from[0], from[1], from[2]),
                            b = grid.at(to[0], to[1], to[2]);
                const float share = std::clamp((level - a) / (b - a), 0.0f, 1.0f);
                vertex = std::int32_t(vertices.size());
                vertices.push_back(grid.place(from[0], from[1], from[2]) * (1 - share) +
                                   grid.place(to[0], to[1], to[2]) * share);
                SbVec3f down = -(grid.gradient(from[0], from[1], from[2]) * (1 - share) +
                                 grid.gradient(to[0], to[1], to[2]) * share);
                if (down.length() > 0) down.normalize();
                directions.push_back(down);
              }
              corners.push_back(vertex);
            }
            corners.push_back(-1);
          }
        }
  }
  SO_ENGINE_OUTPUT(points, SoMFVec3f, setNum(int(vertices.size())));
  SO_ENGINE_OUTPUT(points, SoMFVec3f, setValues(0, int(vertices.size()), vertices.data()));
  SO_ENGINE_OUTPUT(normals, SoMFVec3f, setNum(int(directions.size())));
  SO_ENGINE_OUTPUT(normals, SoMFVec3f, setValues(0, int(directions.size()), directions.data()));
  SO_ENGINE_OUTPUT(coordIndex, SoMFInt32, setNum(int(corners.size())));
  SO_ENGINE_OUTPUT(coordIndex, SoMFInt32, setValues(0, int(corners.size()), corners.data()));
  SO_ENGINE_OUTPUT(triangleCount, SoSFInt32, setValue(int(corners.size() / 4)));
}

}  // namespace resect

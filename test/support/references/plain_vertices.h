// Where an iso-surface crosses the edges between a field's nodes and how it looks there, edge by
// edge and node by node: what brickVertices() and brickLook() do for four at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "isosurface/brick_look.h"
#include "isosurface/brick_mesher.h"

namespace resect::test {

struct PlainVertex {
  Vec3f point;
  Vec3 normal;
  double cut;
};

// Growth of the field from node to node along an axis, averaged across with the weights 1 2 1.
inline double plainSlope(const ColourField& field, const Vec3i& node, int axis) {
  double sum = 0;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const Vec3i d(x, y, z);
        double weight = d[axis] / 32.0;
        for (int a = 0; a < 3; ++a)
          if (a != axis && d[a] == 0) weight *= 2;
        sum += weight * field.node(node + d);
      }
  return sum;
}

inline std::vector<PlainVertex> plainVertices(const ColourField& field, float iso) {
  std::vector<PlainVertex> vertices;
  const NodeGrid grid(field, iso);
  const Vec3i dims = field.nodeDims();
  for (int z = 0; z < dims.z(); ++z)
    for (int y = 0; y < dims.y(); ++y)
      for (int x = 0; x < dims.x(); ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3i low(x, y, z), high = low + Vec3i::Unit(axis);
          if (high[axis] >= dims[axis]) continue;
          const float before = field.node(low), after = field.node(high);
          if ((before >= iso) == (after >= iso)) continue;
          const float way =
              std::clamp((iso - before) / (after - before), kEndMargin, 1 - kEndMargin);
          PlainVertex v;
          for (int a = 0; a < 3; ++a)
            // As from the brick's first node on.
            v.point[a] = float(field.nodePlace(a, low[a] / kBrickNodes * kBrickNodes) +
                               low[a] % kBrickNodes * grid.step[a]);
          v.point[axis] += way * grid.spacing[axis];
          for (int a = 0; a < 3; ++a)
            v.normal[a] =
                -((1 - way) * plainSlope(field, low, a) + way * plainSlope(field, high, a)) /
                grid.step[a];
          v.normal.normalize();
          const float below = field.originalNode(low), above = field.originalNode(high);
          const bool changed = below != before || above != after;
          v.cut = changed ? cutShare((1 - way) * below + way * above, iso) : 0;
          vertices.push_back(v);
        }
  return vertices;
}

}  // namespace resect::test

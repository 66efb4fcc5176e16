#include "surface/brick_mesher.h"

#include <algorithm>

namespace resect {
namespace {

constexpr int kStep[3] = {1, kHalo, kHalo* kHalo};

// Place in the halo of the brick's node (x, y, z), each -1 to 5.
constexpr int at(int x, int y, int z) { return ((z + 1) * kHalo + y + 1) * kHalo + x + 1; }

// Vertices keep this share of an edge away from its ends, so that no two of them fall together.
constexpr float kEndMargin = 1e-3f;
// Colour values below the iso level of the original field over which skin turns into cut
// parenchyma.
constexpr float kCutRange = 15;

Vec3f gradient(const Halo& halo, int node) {
  return {halo[node + kStep[0]] - halo[node - kStep[0]],
          halo[node + kStep[1]] - halo[node - kStep[1]],
          halo[node + kStep[2]] - halo[node - kStep[2]]};
}

}  // namespace

void gatherHalo(const ColourField& field, const Vec3i& brick, Halo& halo) {
  // Bricks one to each side: their nodes -1 (last plane), 0..3, and 4, 5 (first two planes).
  for (int bz = -1; bz <= 1; ++bz)
    for (int by = -1; by <= 1; ++by)
      for (int bx = -1; bx <= 1; ++bx) {
        const Vec3i b = brick + Vec3i(bx, by, bz);
        const auto first = [](int side) { return side < 0 ? -1 : side > 0 ? 4 : 0; };
        const auto last = [](int side) { return side < 0 ? -1 : side > 0 ? 5 : 3; };
        const bool exists = (b.array() >= 0).all() && (b.array() < field.brickDims().array()).all();
        const std::int32_t slot = exists ? field.slot(field.brickIndex(b)) : ColourField::kEmpty;
        for (int z = first(bz); z <= last(bz); ++z)
          for (int y = first(by); y <= last(by); ++y)
            for (int x = first(bx); x <= last(bx); ++x) {
              float& value = halo[at(x, y, z)];
              if (slot >= 0)
                value = field.values(slot)[((z & 3) * 4 + (y & 3)) * 4 + (x & 3)];
              else if (slot == ColourField::kEmpty)
                value = 0;
              else
                value = field.node(kBrickNodes * brick + Vec3i(x, y, z));
            }
      }
}

BrickSigns brickSigns(const Halo& halo, float iso) {
  BrickSigns signs;
  int node = 0;
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x, ++node) {
        const int i = at(x, y, z);
        const bool in = halo[i] >= iso;
        signs.inside |= std::uint64_t(in) << node;
        for (int a = 0; a < 3; ++a)
          signs.crossing[a] |= std::uint64_t(in != (halo[i + kStep[a]] >= iso)) << node;
      }
  return signs;
}

void brickVertices(const ColourField& field, const Vec3i& brick, const Halo& halo,
                   const BrickSigns& signs, float iso, SurfaceVertex* out) {
  const Vec3i first = kBrickNodes * brick;
  const bool edited = field.edited(field.brickIndex(brick));
  for (int axis = 0; axis < 3; ++axis)
    for (std::uint64_t rest = signs.crossing[axis]; rest != 0; rest &= rest - 1) {
      const int node = std::countr_zero(rest);
      const Vec3i local(node & 3, node >> 2 & 3, node >> 4);
      const int a = at(local.x(), local.y(), local.z()), b = a + kStep[axis];
      const float t = std::clamp((iso - halo[a]) / (halo[b] - halo[a]), kEndMargin, 1 - kEndMargin);
      Vec3 where = (first + local).cast<double>();
      where[axis] += t;
      out->position = field.nodePosition(where).cast<float>();
      // Node differences are per node spacing; a stretched lattice turns them into slopes by its
      // own spacing.
      const Vec3f slope = ((1 - t) * gradient(halo, a) + t * gradient(halo, b))
                              .cwiseQuotient(field.lattice().spacing.cast<float>());
      const float length = slope.norm();
      out->normal = length > 0 ? Vec3f(slope / -length) : Vec3f(0, 1, 0);
      out->cut = 0;
      if (edited) {
        const Vec3i from = first + local;
        const float before =
            (1 - t) * field.originalNode(from) + t * field.originalNode(from + Vec3i::Unit(axis));
        out->cut = std::clamp((before - iso) / kCutRange, 0.f, 1.f);
      }
      ++out;
    }
}

}  // namespace resect

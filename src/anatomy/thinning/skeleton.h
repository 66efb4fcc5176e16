// The skeleton of a branching shape: trees of cells that follow its middle.
//
// Method: TEASAR (Sato et al. 2000, 10.1109/PCCGA.2000.883951). In each connected part, paths from
// a root to the farthest cells are found one after another. A path ends where it meets an earlier
// path. After each path, the cells round it are no longer considered as ends of paths. Steps cost
// more the nearer they are to the wall of the shape, so paths run in the middle of the shape.
#pragma once

#include <cstdint>
#include <vector>

#include "anatomy/thinning/solid_shape.h"

namespace resect {

// A tree of neighbouring cells. Cell 0 is the root; every other cell comes after its parent. A
// branch ends before the end of the shape, by about the depth of its last cell.
struct Skeleton {
  std::vector<std::int64_t> cells;  // indices of cells in the shape's lattice
  std::vector<int> parents;         // index in `cells`; -1 for the root
};

// One tree for each connected part of the shape; its root is the widest of the part's ends. Parts
// that are nowhere deeper than one cell are left out. Cost: O(n log n) for n cells inside.
std::vector<Skeleton> skeletons(const SolidShape& shape);

// Moves the roots of trees that meet outside the shape, as the hepatic veins do in the vena cava.
// The meeting point is the end of a tree at which the distances to the nearest ends of the other
// trees have the least sum; trees with less than a fifth of the cells of the largest tree are not
// counted. The root of each tree becomes its end nearest to this point. A single tree is not
// changed.
void rootTogether(const SolidShape& shape, std::vector<Skeleton>& trees);

}  // namespace resect

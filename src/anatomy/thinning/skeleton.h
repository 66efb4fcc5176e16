// The skeleton of a branching shape: trees of cells that follow the middle of the shape.
//
// Method: TEASAR (Sato et al. 2000, 10.1109/PCCGA.2000.883951). In each connected part, paths are
// found one after another. Each path leads from the farthest remaining cell towards the root, and
// ends where it meets an earlier path. Later paths cannot begin at cells close to this path. A step
// near the wall of the shape costs more than a step far from the wall, so paths run in the middle
// of the shape.
#pragma once

#include <cstdint>
#include <vector>

#include "anatomy/thinning/solid_shape.h"

namespace resect {

// A tree of neighbouring cells. Cell 0 is the root; every other cell comes after its parent. A
// branch does not reach the wall at the end of the shape. The gap is about equal to the depth of
// the branch's last cell below the wall (SolidShape::depth).
struct Skeleton {
  std::vector<std::int64_t> cells;  // indices of cells in the shape's lattice
  std::vector<int> parents;         // index in `cells`; -1 for the root
};

// One tree for each connected part of the shape. The root of the tree is the widest end of the
// part. Parts that are nowhere deeper than one cell are left out. Cost: O(n log n) for n cells
// in the shape.
std::vector<Skeleton> skeletons(const SolidShape& shape);

// Moves the roots of trees that meet outside the shape, as the hepatic veins do in the vena cava.
// The meeting point is an end of one of the trees. It is found as follows. For each end, the
// distances to the nearest end of every other tree are added. The end with the least sum is the
// meeting point. This search ignores trees with less than a fifth of the cells of the largest tree.
// Then, in each tree, the end nearest to the meeting point becomes the root. A single tree is not
// changed.
void rootTogether(const SolidShape& shape, std::vector<Skeleton>& trees);

}  // namespace resect

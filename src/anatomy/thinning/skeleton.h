// The middle of a branching shape, as trees of cells.
//
// After TEASAR (Sato et al. 2000, 10.1109/PCCGA.2000.883951): in each connected part, ways from a
// root to the farthest places are found one after another; a way ends where it meets an earlier
// one, and the cells round a way are done with. Ways run in the middle of the shape, since a step
// costs the more the nearer it is to the wall.
#pragma once

#include <cstdint>
#include <vector>

#include "anatomy/thinning/solid_shape.h"

namespace resect {

// A tree of neighbouring cells. Cell 0 is the root; a cell comes after its parent. The outermost
// cells lie about as far before the ends of the shape as they are deep.
struct Skeleton {
  std::vector<std::int64_t> cells;  // of the shape's lattice
  std::vector<int> parents;         // index in `cells`; -1 for the root
};

// One tree for each connected part of the shape; its root is the widest of the part's ends. Parts
// that are nowhere deeper than a cell are left out. Cost: n log n in the cells inside.
std::vector<Skeleton> skeletons(const SolidShape& shape);

// Moves the roots of trees that meet outside the shape, as the hepatic veins do in the vena cava:
// each to the end that is nearest to the place where the trees' ends come closest together. Trees
// with less than a fifth of the longest one's cells do not decide on that place. A single tree
// stays as it is.
void rootTogether(const SolidShape& shape, std::vector<Skeleton>& trees);

}  // namespace resect

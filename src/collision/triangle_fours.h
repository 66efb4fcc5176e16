// What does the test of a tile need to know of a triangle? Worked out for four at a time. For
// collision/tile_caster.cpp alone.
//
// Coverage. A triangle covers a column where its three edge functions V = start + dx Y - dy X are
// all positive, X and Y counted in steps of the raster from its corner 0; where one is negative it
// does not; where one is zero the owner of the edge decides (collision/footprint.h). All are
// integers. In single precision (u = 2^-24) start, dx, dy, X and Y are each rounded once, a product
// that is not fused and each of two sums once more: V comes out wrong by at most
//     5.1 u (|start| + |dx Y| + |dy X|).
// With w, h the sides of the box round the triangle, |dx| <= w, |dy| <= h and |start|, twice the
// area, <= w h; a column of a tile that reaches into the box lies at most three columns and one row
// beyond it. So, with 8 u for 5.1 u,
//     doubt = 2^-21 (w h + w (h + one row) + h (w + three columns))
// and V is positive where V - doubt comes out positive, negative where V + doubt comes out
// negative: what is left of the 8 u, 2.9 u of a sum that is at least as large as doubt / 8 u, is
// more than these two sums' own roundings. Anything between is tested exactly.
//
// Points. The first point beyond the triangle is that below p0 + gx X + gy Y, in points. Where it
// covers a column, |X| <= w and |Y| <= h, so that is wrong by at most 5.1 u (|p0| + |gx| w + |gy|
// h) for the same reasons. gx and gy are worked out in double precision, as differences of products
// over the area: they are wrong by 2^-50 times the sums of these products' sizes, and by what the
// area is, which comes out wrong by 2^-52 w h. Where it is less than 2^-20 w h nothing is left to
// the filter, so that is less than 2^-32 of gx and gy, far below u. The depth that the exact test
// gives is itself rounded, by less than 2^-50 of the depths that it is made of. All this is in
// `slack`, of whose 8 u one goes to the sums with slack themselves: where p is nearer to a whole
// number, the exact depth is asked. A triangle with a slack of a fifth of a point or more is tested
// exactly.
#pragma once

#if defined(__x86_64__)
#include <cstddef>
#include <cstdint>

#include "collision/grid_lines.h"
#include "collision/inside_samples.h"

namespace resect {

struct TriangleFour {
  // Of edges as turned in collision/footprint.h; start0: of edge 0, less doubt. The others start
  // at -doubt.
  alignas(16) float dx[3][4], dy[3][4], start0[4], doubt[4];
  alignas(16) float gx[4], gy[4], p0[4], twoSlacks[4];            // p0: less slack
  alignas(16) std::int32_t x0[4], y0[4];                          // corner 0
  alignas(16) std::int32_t left[4], bottom[4], right[4], top[4];  // tiles, these included
  alignas(16) std::int32_t leaves[4];                             // 1 if the column leaves there
  unsigned filtered;  // bit k: triangle k can be left to the filter
};

// triangles: four numbers of triangles of the mesh, each of which reaches some column; lineSlack:
// see slackOf().
void prepare(const MeshOnGrid& placed, const SampleLine& line, double lineSlack,
             const std::uint64_t* triangles, TriangleFour& four);

}  // namespace resect

#endif

// What does the search for a triangle's columns need to know of it? Worked out for four at a time.
// For collision/span_caster.cpp alone.
//
// Ends. Column numbers c run from the first column of the box round a triangle. Along a row y of
// the raster an edge lies at c = end + slope (y - y of the edge's own corner); on the left the
// triangle begins behind the last of its edges there, on the right it ends before the first. In
// single precision (u = 2^-24) dx, dy, their quotient and y are rounded once each, the sum and the
// end once each: c comes out wrong by at most
//     u (|end| + |c| + 4 |slope y|).
// Only the edge counts that is last, or first: it is so within the box, where |slope y| <= w, the
// box's width in columns. One whose |slope y| is between w and 2 w is wrong by no more than
// u (3 |end| + 12 w); one beyond 2 w lies outside the box by more than w, and no rounding brings it
// in. With |end| <= |x0| + w, x0 that of corner 0, all is less than
//     slack = 2^-20 (|x0| + w) + what a column's own place on the raster may be wrong by.
// Where neither end, less slack and more, has a column between, the columns between the ends are
// those that the exact test (collision/footprint.h) finds; of other rows it is asked.
//
// Points. The first point beyond the triangle is that below p0 + gx c + gy y, in points. Where it
// covers a column, c <= w and |y| <= h, so that comes out wrong by at most
//     6 u (|p0| + |gx| w + |gy| h):
// p0, gx, gy and y rounded once each, and three sums, or a product and four sums for columns beyond
// eight. gx and gy are worked out in double precision, as differences of products over the area:
// they are wrong by 2^-50 times the sums of these products' sizes, and by what the area is, which
// comes out wrong by 2^-52 w h. Where it is less than 2^-20 w h nothing is left to the filter, so
// that is less than 2^-32 of gx and gy, far below u. The depth that the exact test gives is itself
// rounded, by less than 2^-50 of the depths that it is made of. All this is in `pointSlack`, whose
// 8 u leave room for the sums with slack themselves: where p is nearer to a whole number, the exact
// depth is asked. A triangle with a slack of a fifth of a column or point is tested exactly.
#pragma once

#if defined(__x86_64__)
#include <cstddef>
#include <cstdint>

#include "collision/inside_samples.h"
#include "collision/rough_mesh.h"

namespace resect {

struct TriangleFour {
  alignas(16) std::int32_t triangle[4];
  // Edge e lies opposite of corner e and runs through corner 1 if e = 0, else through corner 0.
  // left and right: where it lies at that corner, less slack; beyond all columns on the side where
  // it is not. twoSlacks: in columns.
  alignas(16) float slope[3][4], left[3][4], right[3][4], twoSlacks[4];
  alignas(16) float gx[4], gy[4], p0[4], twoPointSlacks[4];  // p0: less slack
  alignas(16) std::int32_t y0[4], y1[4];                     // of corners 0 and 1
  // The box: firstRow <= row < lastRow, and how many columns from the first.
  alignas(16) std::int32_t firstColumn[4], firstRow[4], lastRow[4];
  alignas(16) float columns[4];
  alignas(16) std::int32_t leaves[4];  // 1 if the column leaves there
  unsigned filtered;                   // bit k: triangle k can be left to the filter
};

// triangles: four numbers of triangles of the mesh, each of which reaches some column; lineSlack:
// see slackOf().
void prepare(const RoughMesh& placed, const SampleLine& line, double lineSlack,
             const std::int32_t (&triangles)[4], TriangleFour& four);

}  // namespace resect

#endif

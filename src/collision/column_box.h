// Where do the columns of a box of the grid cross a triangle that may cover several? For
// collision/grid_hits.cpp alone; the test is that of collision/footprint.h, bit for bit.
#pragma once

#include "collision/footprint.h"
#include "collision/lone_columns.h"

namespace resect {

// Columns and rows [first, last) of the grid.
struct ColumnBox {
  GridCell first, last;
};

constexpr int kBoxStep = 4;  // columns that are tested together

// Adds a hit for each column of the box that the triangle covers. The box is the triangle's own, or
// part of it: no column lies beyond its corners. raster.columns: may be read kBoxStep beyond the
// box. Four columns at a time on machines with AVX2; the plain one for comparison.
void castBox(const Footprint& footprint, const GridRaster& raster, const ColumnBox& box,
             RowHits& hits);
void castBoxPlainly(const Footprint& footprint, const GridRaster& raster, const ColumnBox& box,
                    RowHits& hits);

}  // namespace resect

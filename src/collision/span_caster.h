// Which columns of a row does a triangle cover, and between which points of a line along them does
// it cross each? Eight rows' ends, then eight columns at a time in single precision, exactly where
// that is in doubt. For collision/span_samples.cpp, on machines with AVX2 and fused products.
#pragma once

#if defined(__x86_64__)
#include <cstddef>
#include <cstdint>

#include "collision/inside_samples.h"
#include "collision/lone_points.h"
#include "collision/rough_mesh.h"
#include "collision/step_rows.h"
#include "collision/triangle_fours.h"

namespace resect {

// Spans that wait until there are many: one loop casts them all, with no end in it to be guessed.
struct SpanList {
  static constexpr int kRoom = 128;

  int count = 0;
  // A place in StepRows; how many columns from there on (kSpan or more: kSpan; none: 0 or less).
  std::int32_t place[kRoom];
  float columns[kRoom];
  // Of the triangle: see TriangleFour. point: at the first column.
  float point[kRoom], gx[kRoom], twoSlacks[kRoom];
  std::int32_t leaves[kRoom], triangle[kRoom];
};

class SpanCaster {
 public:
  // line.count: at most kMostPoints.
  SpanCaster(const RoughMesh& placed, const SampleLine& line);

  // Adds the steps of triangles [begin, end).
  void cast(std::size_t begin, std::size_t end, StepRows& rows) const;

 private:
  std::int32_t pointsUpTo(double depth) const;
  void castLone(const SortedRun& run, StepRows& rows) const;
  void castLarger(const SortedRun& run, StepRows& rows) const;
  void listSpans(const TriangleFour& four, std::size_t k, SpanList& list, StepRows& rows) const;
  void listRows(const TriangleFour& four, std::size_t k, int y, SpanList& list,
                StepRows& rows) const;
  void listRest(SpanList& list, int some, StepRows& rows) const;
  void castListed(SpanList& list, StepRows& rows) const;
  void castExactly(std::int32_t triangle, StepRows& rows) const;
  [[gnu::noinline]] void castRowExactly(std::int32_t triangle, int y, StepRows& rows) const;
  [[gnu::noinline]] void stepsExactly(const SpanList& list, int k, GridCell first,
                                      Step (&steps)[kSpan]) const;

  const RoughMesh& placed_;
  SampleLine line_;
  double perPitch_;
  double slack_;   // see slackOf()
  float highest_;  // place beyond which all are behind the last point
};

}  // namespace resect

#endif

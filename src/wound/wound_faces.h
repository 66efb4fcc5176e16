// The lines in which the surface of a cut organ meets a face of the grid.
//
// The lines depend on the face alone, so the cells on both sides of it have the same lines; this is
// why the surface is closed. Along the face's border solid parts ("runs") alternate with gaps. A
// gap is a cut edge, which has no width, or a stretch outside the tissue. Seen along the border, in
// the order of its corners, a line leads from the end of a run either back to the start of the same
// run, which it cuts off, or across a gap to the start of another. Each end and each start has one
// line. In three cases the lines
// pass through one point of the face, each with a vertex of its own there: where three or four cuts
// meet, where a cut ends in the face, and where a cut meets the organ's surface ("skin").
#pragma once

#include "wound/wound_edges.h"

namespace resect {

// Kind of a face's own point.
enum class FacePoint : std::uint8_t {
  None,
  Tip,       // the cut ends here
  Junction,  // three or four pieces meet
  Skin       // the cut meets the skin
};

struct FaceLine {
  // The edge points that the line joins, as 3 * ring edge + EdgeNode. Tissue lies to the left of
  // the line, seen from above the face.
  std::uint8_t end = 0, start = 0;
  bool bent = false;      // passes through the face's point, with a vertex of its own
  NearbyNodes anchors{};  // of the line's vertex, relative to the face's node
};

struct FaceLines {
  static constexpr int kMost = 5;
  std::array<FaceLine, kMost> line;
  int count = 0;
  FacePoint kind = FacePoint::None;
  Vec3 point = Vec3::Zero();  // in the coordinates of the CutGrid's nodes
  int points() const {        // number of vertices at the face's point
    int n = 0;
    for (int i = 0; i < count; ++i) n += line[std::size_t(i)].bent;
    return n;
  }
};

// Ring edge i is an edge of a face's border, between corners i and i + 1. The corners, as offsets
// from the face's node, are 0, u, u + v and v, with the unit vectors u along nextAxis() and v along
// lastAxis(). offset: the edge's lower node, from the face's node; axis: the edge's own axis.
struct RingEdge {
  Vec3i offset;
  int axis;
};
inline RingEdge ringEdge(int axis, int i) {
  const int u = nextAxis(axis), v = lastAxis(axis);
  if (i == 1) return {Vec3i::Unit(u), v};
  if (i == 2) return {Vec3i::Unit(v), u};
  return {Vec3i::Zero(), i == 0 ? u : v};
}

// Whether the organ's surface continues through the face at node i although edges of the face are
// cut. It does not if a blade crosses the surface's line in the face. It does not either if the
// nodes that own the two ends of that line are not joined by whole grid edges inside a small box:
// the two cells beside the face, widened by one node on every side.
bool skinHolds(const CutGrid& grid, int i, int axis);

// The lines of the face at node i. holds() gives the answer of skinHolds(); in tests it may give
// any answer, since the surface is closed with either. It is called only if the lines depend on it.
template <typename Holds>
FaceLines faceLines(const CutGrid& grid, int i, int axis, const Holds& holds);
FaceLines faceLines(const CutGrid& grid, int i, int axis);

namespace wound {

// A gap in the ring. It leads from the edge point at the end of a run to that at the start of the
// next.
struct Gap {
  std::uint8_t end = 0, start = 0;
  bool outside = false;   // true: outside the tissue; false: a cut edge
  NearbyNodes anchors{};  // of the run after the gap, relative to the face's node
};
struct Ring {
  std::array<CutEdge, 4> edge;
  std::array<Gap, FaceLines::kMost> gap;
  int gaps = 0, cuts = 0, outside = 0;  // gaps in all; gaps at cut edges; gaps outside the tissue
};
Ring ringOf(const CutGrid& grid, int i, int axis);
FaceLines linesOf(const CutGrid& grid, int i, int axis, const Ring& ring, bool skinHolds);

}  // namespace wound

template <typename Holds>
FaceLines faceLines(const CutGrid& grid, int i, int axis, const Holds& holds) {
  const wound::Ring ring = wound::ringOf(grid, i, axis);
  return wound::linesOf(grid, i, axis, ring, ring.cuts > 0 && ring.outside > 0 && holds());
}

}  // namespace resect
